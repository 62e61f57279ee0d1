"""What the page answers in pictures, each with a sentence that is read off the cases.

A picture is a function of a Study that returns content.Answer, or None where the study has no data
for it. A new one is a function here and its name in `answers`.
"""

from content import Answers
from sections.answers.cost import cost_of_accuracy
from sections.answers.distance import distance_over_nu
from sections.answers.limits import first_failures
from sections.answers.shapes import look_of_bodies

__all__ = ["answers"]


def answers(study):
    """A list of one block, of none where there is nothing to answer with."""
    makers = (distance_over_nu, cost_of_accuracy, first_failures, look_of_bodies)
    found = [answer for answer in (maker(study) for maker in makers) if answer]
    return [Answers(found)] if found else []
