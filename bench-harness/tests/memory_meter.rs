//! The meter of memory, in a process of its own: other tests would give memory back meanwhile.

use bench_harness::engine::meter::Peak;

#[test]
fn memory_that_is_written_to_is_seen() {
    let Some(peak) = Peak::begin() else {
        return; // not Linux
    };
    let written = std::hint::black_box(vec![1_u8; 64 << 20]);
    let rise = peak.bytes().expect("a peak that began");
    assert!(rise >= 60 << 20, "{rise} for {}", written.len());
}
