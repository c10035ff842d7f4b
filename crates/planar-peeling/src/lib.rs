//! Green and Silverman's hull and peels, Graham's scan, Andrew's monotone chain.
