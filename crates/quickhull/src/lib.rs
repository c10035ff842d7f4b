//! Quickhull in its historical and modern forms.
