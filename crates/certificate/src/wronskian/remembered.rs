//! A cache of results for cells.
//!
//! Whether all coefficients are positive on a cell is a function of exact data: the coefficients of the operator
//! (names of variables and parameters do not matter), the degree, the determinants that are expanded, and the cell.
//! Papers share bases, and the search for a certificate ends with the very cells of the certificate; so results are
//! cached for the life of the process. Each result is stored with all the data on which it depends, and the data are
//! compared, not hashes of them. A thread that needs a result that another thread is computing waits for it.

use super::Unfit;
use super::certificate::Cell;
use super::operator::Part;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use torse_numbers::Rational;

/// The largest number of cached results; further ones are computed every time.
const MAX_REMEMBERED: usize = 1024;

/// All data on which the result depends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Question {
    pub parts: Vec<Vec<Part>>,
    pub degree: usize,
    pub exact: Vec<u8>,
    pub from: Rational,
    pub cell: Cell,
    /// Whether a deliberate fault is injected; such results are kept apart.
    pub mistaken: bool,
}

type Answer = Arc<OnceLock<Result<(), Unfit>>>;

static ANSWERS: Mutex<Vec<(Question, Answer)>> = Mutex::new(vec![]);

/// Returns the cached result, or computes it.
pub(super) fn answer(
    question: Question,
    find: impl FnOnce() -> Result<(), Unfit>,
) -> Result<(), Unfit> {
    let place = {
        // If a thread panicked the list is still valid, because entries are only added.
        let mut all = ANSWERS.lock().unwrap_or_else(PoisonError::into_inner);
        match all.iter().find(|(asked, _)| *asked == question) {
            Some((_, answer)) => Arc::clone(answer),
            None => {
                let answer = Answer::default();
                if all.len() < MAX_REMEMBERED {
                    all.push((question, Arc::clone(&answer)));
                }
                answer
            }
        }
    };
    place.get_or_init(find).clone()
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_numbers::rational::{integer, ratio};

    #[test]
    fn an_answer_belongs_to_all_of_its_question() {
        let question = Question {
            parts: vec![],
            degree: 77,
            exact: vec![],
            from: integer(0),
            cell: Cell {
                until: ratio(1, 2).unwrap(),
                nodes: 20,
                radius: integer(2),
            },
            mistaken: false,
        };
        assert_eq!(answer(question.clone(), || Ok(())), Ok(()));
        assert_eq!(answer(question.clone(), || Err(Unfit::Cell)), Ok(()));
        let narrower = Cell {
            nodes: 21,
            ..question.cell.clone()
        };
        let others = [
            Question {
                degree: 78,
                ..question.clone()
            },
            Question {
                parts: vec![vec![]],
                ..question.clone()
            },
            Question {
                exact: vec![1],
                ..question.clone()
            },
            Question {
                from: integer(1),
                ..question.clone()
            },
            Question {
                cell: narrower,
                ..question.clone()
            },
            Question {
                mistaken: true,
                ..question
            },
        ];
        for other in others {
            assert_eq!(answer(other, || Err(Unfit::Cell)), Err(Unfit::Cell));
        }
    }
}
