"""What is said of the rest, of whose each is, or taken back, in words the rules know."""

import re

from apartgen.stages.plan.reader.patterns import late


def _theirs(found: re.Match[str]) -> str:
    """`two baths: hers off the bedroom, his off the hall` as the first and the second."""
    names = iter(("the first", "the second", "the third"))
    return re.sub(r"\b(?:his|hers|mine|ours|theirs)\b", lambda one: next(names, one.group()), found.group())


_SAID = [(late(pattern), words) for pattern, words in (
    # "all face south except the smallest, which faces north", "two baths: hers off the bedroom, his off the hall"
    (r"\b(except|apart from|other than) (the [a-z]+(?: one| bed ?room| bath ?room)?),? which "
     r"(?=(?:faces|is|has|gets|opens|lies)\b)", r"\1 \2. \2 "),
    (r"\b(?:two|2) (?:bath ?rooms|baths|studies|offices|balconies|closets)\b[^.;:]{0,20}[:;.,-] ?(?:and )?"
     r"(?:his|hers|mine)\b[^.;]*", _theirs),
    # "The kitchen is 10 m² - er, 12.", "the balcony can go", "half of it for the living room"
    (r"(?:,| -)+ ?(?:erm?|uhm?|umm?|ah|eh),? (?=\d|no\b|make|sorry|rather|i mean)", ", sorry, "),
    (r"\bthe ([a-z ]{4,16}?) (?:can|may|has to|should|must) (?:also )?go(?= ?(?:[.,;!]|$))", r"forget the \1"),
    (r"\b(half|a third|a quarter|two thirds|\d\d ?%) of (?:it|that|this)(?: is| goes| being)? (?:for|to) the "
     r"([a-z]+(?: room)?)",
     r"the \2 is \1 of the area"),
)]  # fmt: skip


def retold(text: str) -> str:
    """A folded text with such clauses in the words of rooms."""
    for pattern, words in _SAID:
        text = pattern.sub(words, text)
    return text
