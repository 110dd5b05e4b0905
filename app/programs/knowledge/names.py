"""What things are called → words that can be compared: lower case, apart, the last one singular."""

import re
import unicodedata
from collections.abc import Mapping

from app.programs.knowledge.word_lists import word_list

DETERMINERS = word_list("determiners")
PORTIONS = word_list("portions")
"""``a slice of cheese`` is cheese."""
NUMBERS = {
    "one": "1", "two": "2", "three": "3", "four": "4", "five": "5", "six": "6", "seven": "7",
    "eight": "8", "nine": "9", "ten": "10",
}  # fmt: skip
_APART = re.compile(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Za-z])(?=\d)|(?<=\d)(?=[A-Za-z]{2})")
_WORD = re.compile(r"[^\W_]+(?:[\u2019'][^\W_]+)*")
_PLAIN = re.compile(r"[a-z ]*")
"""Nothing in it has to be taken apart or written in another way."""
_SAME = word_list("same")
"""Ends in s, or has no other form."""
_IRREGULAR = {
    "knives": "knife",
    "loaves": "loaf",
    "leaves": "leaf",
    "shelves": "shelf",
    "halves": "half",
    "scarves": "scarf",
    "wolves": "wolf",
    "calves": "calf",
    "mice": "mouse",
    "geese": "goose",
    "feet": "foot",
    "teeth": "tooth",
    "children": "child",
    "people": "person",
    "men": "man",
    "women": "woman",
    "oxen": "ox",
    "dice": "die",
    "cookies": "cookie",
    "movies": "movie",
    "pies": "pie",
    "ties": "tie",
    "brownies": "brownie",
    "smoothies": "smoothie",
    "veggies": "veggie",
    "plushies": "plushie",
    "selfies": "selfie",
    "hoodies": "hoodie",
    "beanies": "beanie",
    "shoes": "shoe",
    "toes": "toe",
    "axes": "axe",
    "lenses": "lens",
    "buses": "bus",
    "gases": "gas",
    "cacti": "cactus",
    "fungi": "fungus",
    "wheelies": "wheelie",
    "calories": "calorie",
    "genies": "genie",
    "caches": "cache",
    "headaches": "headache",
    "avalanches": "avalanche",
    "canoes": "canoe",
    "quiches": "quiche",
}


def plain(text: str) -> str:
    """Lower case, without accents on Latin letters, in one form of Unicode."""
    if text.isascii():  # Nearly all is, and tables of it are read at the start.
        return text.lower()
    apart = unicodedata.normalize("NFKD", text.replace("ß", "ss").replace("œ", "oe"))
    kept = "".join(letter for letter in apart if not unicodedata.combining(letter))
    return unicodedata.normalize("NFC", kept).lower()


def words(text: str) -> tuple[str, ...]:
    """The words and numbers of a name or phrase, lower case; ``bowl_2`` and ``redBowl`` come apart."""
    if _PLAIN.fullmatch(text):
        return tuple(text.split())
    found = (plain(each).replace("\u2019", "'") for each in _WORD.findall(_APART.sub(" ", text)))
    return tuple(each for each in found if each)


def singular(word: str, irregular: Mapping[str, str] = _IRREGULAR) -> str:
    """The word as it is said of one thing; what is singular stays as it is."""
    if word in _SAME or len(word) < 3:
        return "die" if word == "dice" else word
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if word in irregular:
        return irregular[word]
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith("ves") and word[:-3] in ("kni", "li", "wi", "shel", "lea", "loa", "hal", "el"):
        return word[:-3] + "f"
    if re.search(r"(ss|x|z|ch|sh|to|ss)es$", word) and word[-4:] not in ("axes",):
        return word[:-2]
    if word.endswith("s") and word[-2] not in "siu'":
        return word[:-1]
    return word


def stem(word: str) -> str:
    """What verb forms share: ``cutting``, ``cuts`` and ``cut`` are one."""
    word = singular(word)
    for ending in ("ing", "ed", "er"):
        if word.endswith(ending) and len(word) - len(ending) >= 3:
            word = word[: -len(ending)]
            if len(word) > 3 and word[-1] == word[-2] and word[-1] not in "lsz":
                word = word[:-1]
            break
    return word[:-1] if word.endswith("e") and len(word) > 3 else word


def without_marks(found: tuple[str, ...]) -> tuple[str, ...]:
    """The words of a name without what only tells look-alikes apart at its end: ``cup 2``, ``vial two``."""
    while len(found) > 1 and (is_mark(found[-1]) or found[-1] in NUMBERS):
        found = found[:-1]
    return found


def is_mark(word: str) -> bool:
    """Whether the word only tells look-alikes apart, as in ``cup 2`` and ``cup b``."""
    return word.isdigit() or (len(word) == 1 and word.isascii())
