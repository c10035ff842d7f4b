//! A set of small numbers, a bit for each.

/// Numbers below a limit; none of the storage is there before the first number.
#[derive(Debug, Default)]
pub(super) struct Marks {
    words: Vec<u64>,
}

impl Marks {
    /// Adds `number`, which is below `limit`; the limit is the same in every call.
    #[inline]
    pub(super) fn insert(&mut self, number: u32, limit: usize) {
        if self.words.is_empty() {
            self.words.resize(limit.div_ceil(64), 0);
        }
        self.words[number as usize / 64] |= 1 << (number % 64);
    }

    /// Whether `number` is one of them.
    #[inline]
    pub(super) fn contains(&self, number: u32) -> bool {
        let word = self.words.get(number as usize / 64);
        word.is_some_and(|word| word >> (number % 64) & 1 == 1)
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// All numbers in order.
    pub(super) fn ascending(&self) -> Vec<u32> {
        let count = self.words.iter().map(|word| word.count_ones()).sum::<u32>();
        let mut numbers = Vec::with_capacity(count as usize);
        for (start, &word) in (0_u32..).step_by(64).zip(&self.words) {
            let mut rest = word;
            while rest != 0 {
                numbers.push(start + rest.trailing_zeros());
                rest &= rest - 1;
            }
        }
        numbers
    }
}

#[cfg(test)]
mod tests {
    use super::Marks;

    #[test]
    fn numbers_come_back_in_order() {
        let mut marks = Marks::default();
        assert!(marks.is_empty() && !marks.contains(7));
        for number in [129, 0, 64, 63, 7, 129] {
            marks.insert(number, 130);
        }
        assert_eq!(marks.ascending(), [0, 7, 63, 64, 129]);
        assert!(marks.contains(64) && !marks.contains(65) && !marks.is_empty());
    }
}
