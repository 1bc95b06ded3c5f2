//! Cells that were evaluated before.
//!
//! Whether all coefficients are positive on a cell is a function of exact data: the operator by its coefficients (the names
//! of variable and parameters do not matter), the degree, the determinants multiplied out, and the cell. Papers share
//! bases, and the search for a certificate ends with the very cells that the certificate has; so the answers of this
//! process are kept, each with all the data that it is the answer to, and data are compared, not digests of them. A thread
//! that asks what another is just finding out waits for its answer.

use super::Unfit;
use super::certificate::Cell;
use super::operator::Part;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use torse_numbers::Rational;

/// The most answers that are kept; what comes later is evaluated every time.
const MAX_REMEMBERED: usize = 1024;

/// All that the answer depends on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Question {
    pub parts: Vec<Vec<Part>>,
    pub degree: usize,
    pub exact: Vec<u8>,
    pub from: Rational,
    pub cell: Cell,
    /// A deliberate mistake that is under way answers for itself alone.
    pub mistaken: bool,
}

type Answer = Arc<OnceLock<Result<(), Unfit>>>;

static ANSWERS: Mutex<Vec<(Question, Answer)>> = Mutex::new(vec![]);

/// The answer from before, or the one that is found now.
pub(super) fn answer(
    question: Question,
    find: impl FnOnce() -> Result<(), Unfit>,
) -> Result<(), Unfit> {
    let place = {
        // A thread that failed left the list as it was: entries are only added.
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
