"""Turns of phrase that say a plain thing in a roundabout way → the plain way, for the model that reads it.

Each rule is one that English has; what no rule knows stays as it is.
"""

import re

from app.programs.knowledge.names import plain, singular
from app.programs.knowledge.word_lists import word_list

_PLACING = r"(?:in|into|inside|on|onto|to)"
_CORRECTION = re.compile(
    rf"\b({_PLACING}) (?:the|my|your|that|this) [\w' -]{{1,40}}?\s*(?:,|\.\.\.|\u2026|\u2014|-)+\s*"
    r"(?:(?:that is|that's|i mean|i meant|or rather|rather|no|sorry|wait|make that|i\.e\.)[, ]+)+"
    rf"(?:{_PLACING} )?(?=(?:the|my|your|that|this)\b)",
    re.I,
)
"""In the left basket, I mean, the rattan one."""
_GIVEN = re.compile(
    r"\bgive (?P<what>(?:the|my|your|that|this|both|all)\b[^,.;]*?) an? (?:bit of an? )?(?:\w+ )??"
    r"(?P<deed>push|shove|nudge|prod|wipe|stir|shake|rinse|wash|pull|twist|polish|clean|brush|press)\b",
    re.I,
)
_DEEDS = {"shove": "push", "nudge": "push", "prod": "push"}
_ONLY_STAYS = re.compile(
    r"[,;]? (?:and |but )?(?:only|just) (?P<what>(?:the|my|that|this) [\w' -]+?) (?:can |should |must |may )?"
    r"(?:stays?|remains?|(?:is|are|be) left)\b(?: (?:where|as) (?:it is|they are|it's|they're)| put| here| there| behind| out| alone)?",
    re.I,
)
_ONLY = re.compile(r",? and only (?:the )?[\w-]+,?(?= )|, only (?:the )?\w+ ones?\b", re.I)
_INTRODUCED = re.compile(
    r"^(?P<before>(?:.*[.!?:;] )?)(?:there(?: are|'re| is|'s)|here are|of (?:the|my|our|your|these|those)|"
    r"(?:do you |you can )?see (?:the|my|our|these|those)|"
    r"you(?:'ll)? (?:see|have)|i(?:'ve| have)(?: got)?) "
    r"(?:all )?(?:two|three|four|five|six|several|some|a few|a pair of|a row of) "
    r"(?P<noun>(?:[a-z-]+ )?[a-z-]+s|mice|knives|shelves|loaves)\b[^.,:;!?]*[.,:;!?]\s+",
    re.I,
)
_ONE = re.compile(
    r"\b(the (?:very )?[\w-]+) one\b|\b(the) one(?= (?:in|on|at|to|with|that|nearest|furthest)\b)",
    re.I,
)
_OTHER = re.compile(
    r"\bthe other\b(?: one\b)?(?=\s*[,.;:!?]|$| (?:goes|belongs|in|into|on|onto|is|can|should|needs|wants|must|to|and)\b)",
    re.I,
)


_SO_DOES = re.compile(
    r"(?P<goes> (?:goes|belongs?|go) (?P<where>(?:in|into|on|onto|inside) (?:the|my|that) [\w' -]+?))"
    r"(?:[.;,] (?:and )?so (?:does|do|should|must)|[,;] as (?:does|do|should|must)) (?P<what>the [\w' -]+?)"
    r"(?=[.,;!]|$)",
    re.I,
)
"""The blue sock goes in the drawer. So does the grey one."""
_SPILT = re.compile(r"\b(?:poor|por|pore) (?=(?:the|some|all|out|my)\b)", re.I)
"""Nobody says "poor the milk" who does not want it poured."""
_ONE_FOR = re.compile(r"\b(?:that(?:'s| is)|it(?:'s| is)) one for (?=(?:the|my)\b)", re.I)
"""That's one for the bin."""
_CLEARED = re.compile(
    r"\bclear (?:off |out )?(?:the |my |this )(?:whole |entire )?"
    r"(?:desk|table|tabletop|counter|bench|workbench|worktop|place) (?=(?:into|onto|in|to)\b)|"
    r"^(?:put |get |take |move )?everything (?:off|from) (?:the|my|this) (?:desk|table|tabletop|counter|bench|workbench|worktop)"
    r"(?:,? and)? (?:goes |go )?(?=(?:into|onto|in|on|to) (?:the|my|that)\b)",
    re.I,
)
_WITH_EXCEPTION = re.compile(r",? with the (?:sole |single |one )?exception of ", re.I)
_STATE = re.compile(
    r"^(?:the|my|your) [\w' -]{1,30}? (?:is|are)(?: already| still| now)? (?:wide )?"
    r"(?:open|closed|shut|empty|full|clean|dirty|ready)[.!]$",
    re.I,
)
"""The box is open."""
_NEEDED = re.compile(
    r"(?P<what>\b(?:the|my|your|that|this) [\w' -]+?) (?:needs?|wants?|could do with)"
    r"(?: to be)? (?P<deed>opening|closing|shutting|pushing|emptying|opened|closed|shut|pushed)\b",
    re.I,
)
_NEEDS = {"shutting": "close", "shut": "close", "emptying": "empty"}
_BAR = re.compile(
    r"(?<=\w) (?:bar|save for|excluding|not counting|minus) (?=(?:the|my|that|those)\b)"
)
_BAR_FIRST = re.compile(
    r"(?:^|(?<=[.!?;] ))(?:bar|barring|save for|minus) (?=(?:the|my|that|those)\b)", re.I
)
"""Bar the saw, the tools go in the box."""
_NONE_LEFT = re.compile(
    r"\bno (?P<what>\w+)(?: is| should be| must be)? (?:left out|left behind|left|missing|forgotten|spared),? "
    r"(?:other than|except(?: for)?|apart from|but|save(?: for)?) (?=(?:the|my|that|this)\b)",
    re.I,
)
"""Into the toolbox, no tool left out other than the saw."""
_IF = re.compile(
    r"^(?:so )?if (?:it|something|anything|a thing|they|things)(?:'s| is|'re| are)? "
    r"(?P<so>[^,]+),? (?:then )?(?:it|they|that) (?P<goes>goes?|belongs?|should|must|can)\b",
    re.I,
)
_ASIDE = re.compile(r"\s*\((?:only|just|not|mind|no|the|and)\b[^()]*\)", re.I)
_OTHERS_STAY = re.compile(
    r"[,;]? and (?:the )?(?:others?|rest|other \w+|remaining \w+|remainder) "
    r"(?:can |should |must |may )?(?:stays?|remains?|(?:is|are|be) left)\b[^.;]*|"
    r"[,;]? and (?:keep|leave|save) the (?:fourth|third|fifth|last|other)\b[^.;]*",
    re.I,
)
_BETWEEN = re.compile(
    r"\b(?P<which>the|that|this) (?P<what>(?:\w+ )??\w+)(?:,? (?:that|which)(?:'s| is| lies| stands| sits))?"
    r"(?: sitting| lying| standing)? (?:in )?between the other (?:two|ones)\b",
    re.I,
)
_MIDDLE = re.compile(
    r"\bthe (?P<what>(?:\w+ )??\w+) in the (?:middle|cent(?:re|er))"
    r"(?= (?:goes|belongs|should|must|can|needs|in|inside|into|on|onto|to)\b)",
    re.I,
)
_WHICH_BOTH = re.compile(
    r"\bwhich (?P<what>\w+) are both (?P<one>\w+) and (?P<other>\w+)\? (?P<deed>\w+) (?:those|them|these)\b",
    re.I,
)
_COLON_LIST = re.compile(
    r"(?:(?<=^)|(?<=[.!;] ))(?P<what>[A-Z][\w' -]*): (?P<where>(?:the )?[\w' -]+)(?=[.;]|$)"
)
_BOTH = re.compile(
    r"\b(?:whatever|everything|anything|all|those)(?: that| which)?(?:'s| is| are)? both (\w+) and (\w+)",
    re.I,
)
_GETS = re.compile(
    r"(?P<start>^|[.;,] )(?P<what>(?:the )?[\w-]+(?: [\w-]+)?) (?:gets|(?<=s )get) (?P<where>(?:the|my|a) [\w -]+?)(?=[,.;]|$| and )",
    re.I,
)
_HOLDER = re.compile(
    r"(?:box|bin|crate|basket|tray|bowl|bag|drawer|tin|jar|rack|shelf|bucket|case|cup)$", re.I
)
_SIDE = re.compile(r"\b(left|right)[- ]hand side\b", re.I)
_SIDE_OF_ALL = re.compile(
    r"\b((?:left|right)(?:[- ]hand)?(?: side| end)?|middle|cent(?:re|er)) of "
    r"(?:the|my|your|this) (?:table|tabletop|desk|counter|worktop|bench|workbench|row|line|scene)\b"
    r"(?=,? (?:in|on|into|onto|inside|goes?|belongs?|should|must|can|needs?)\b)",
    re.I,
)
"""A side of what everything stands on is a side, and no thing."""
_LYING = re.compile(
    r"(?<! is)(?<! are),? (?:that(?:'s| is| are)?|which (?:is|are) )?\s*(?:just )?(?:lying|scattered|strewn|sitting|standing|left|spread|littered)"
    r" (?:about|around|everywhere|all over(?: the (?:place|table|floor))?|here and there)\b",
    re.I,
)
"""Things that lie about are things."""
_HASTE = re.compile(
    r",? (?:and )?(?:be )?(?:as )?(?:quick|quickly|fast|soon) as (?:you can|possible)\b", re.I
)
_HANDS_OFF = re.compile(
    r"\b(?:nobody|no one|don't|do not|never)(?: is to)? (?:lays?|puts?) (?:a finger|a hand|hands) on\b",
    re.I,
)
_INSIDE = re.compile(
    r"\bopen(?: up)? (?P<box>(?:the|my) [\w ]+?),? (?P<link>(?:and |then )*)"
    r"(?P<deed>\w+ (?:the|my|a|some) [\w ]+?) (?:inside|in there|in it)(?=[,;.]| and |$)",
    re.I,
)
_LISTED = re.compile(r"^(?P<before>[^:.!?]*\b(?P<last>\w+))\s*:\s+(?P<list>.+)$")
_ORDERS = re.compile(
    r"\b(?:stack|tower|pile|order|top|bottom|first|last|open|close|pour|push|all|every\w*)\b", re.I
)
"""What the list after the colon is told by."""
_INTRODUCING = word_list("introducing")
"""Words before a colon that promise a list and say nothing themselves: "my things: …", "like so: …"."""
STAYS = re.compile(
    r"^(?:the|my|your|those|these|that|this|all the)\b[^,:]*?\b(?:can |should |must |may |shall |will )?stays?"
    r"(?! (?:cold|cool|chilled|frozen|warm|hot|dry|moist|fresh|clean|safe|together|upright|flat|sharp|dark|crisp|hidden)\b)"
    r"(?: put| here| there| where (?:it is|they are|it's|they're)| as (?:it is|they are)| behind| home| away| out(?: of (?:it|this))?|)(?:, [^.!;]*)?\s*[.!]?$",
    re.I,
)
_NONE = re.compile(r"^no [\w' -]+[.!]?$", re.I)
"""No ham."""
_WHOLE = re.compile(r"\b(?:every\w*|all|rest|any\w*|others?|remaining|each|whole)\b", re.I)


def rephrased(sentence: str) -> str:
    """The English sentence without corrections, gifts of a push, and introductions."""
    text = _HASTE.sub("", _HANDS_OFF.sub("leave", sentence))
    text = _LYING.sub("", text)
    text = _CORRECTION.sub(r"\1 ", _SIDE.sub(r"\1", _SIDE_OF_ALL.sub(r"\1", text)))
    text = _SPILT.sub("pour ", _SO_DOES.sub(r"\g<goes> and \g<what> goes \g<where>", text))
    text = _GIVEN.sub(lambda found: f"{_deed(found['deed'])} {found['what']}", text)
    text = _NEEDED.sub(lambda found: f"{_need(found['deed'])} {found['what']}", text)
    text = _ONLY_STAYS.sub(r" except \g<what>", _ASIDE.sub("", text))
    text = _BAR.sub(" except ", _ONLY.sub("", text))
    text = _WITH_EXCEPTION.sub(" except ", _CLEARED.sub("put everything ", text))
    text = _ONE_FOR.sub("put it in ", text)
    text = _NONE_LEFT.sub(r"all the \g<what>s except ", text)
    text = _BAR_FIRST.sub("Except for ", text)
    text = _IF.sub(lambda found: f"everything {found['so']} {found['goes']}", text)
    text = _BOTH.sub(r"all the \1 \2 things", text)
    text = _GETS.sub(_given_to, text)
    text = _INSIDE.sub(r"open \g<box>, \g<link>\g<deed> in \g<box>", text)
    text = _WHICH_BOTH.sub(r"\g<deed> all the \g<one> \g<other> \g<what>", text)
    text = _MIDDLE.sub(r"the middle \g<what>", text)
    text = _BETWEEN.sub(r"\g<which> middle \g<what>", _OTHERS_STAY.sub("", text))
    if len(_COLON_LIST.findall(text)) > 1:
        text = _COLON_LIST.sub(lambda found: f"put {found['what']} in {found['where']}", text)
    return _introduced(_without_stays(_listed(text)))


def _given_to(found: re.Match[str]) -> str:
    """Who gets what: "clothes get the suitcase" as well as "the toolbox gets the tools"."""
    what, where = found["what"], found["where"]
    if _HOLDER.search(what) and not _HOLDER.search(where):
        what, where = where, what
    return f"{found['start']}put {what} in {where}"


def _deed(word: str) -> str:
    return _DEEDS.get(word.lower(), word.lower())


def _need(word: str) -> str:
    return _NEEDS.get(word.lower()) or re.sub(r"(?:ing|ed)$", "", word.lower()).replace(
        "clos", "close"
    )


def _listed(text: str) -> str:
    """Without what only announces a list of what goes where."""
    match = _LISTED.match(text)
    if match is None:
        return text
    placed = len(re.findall(rf"\b{_PLACING}\b", match["list"]))
    announces = not re.search(rf"\b{_PLACING} (?:the|my|a)\b", match["before"])
    if match["last"].lower() not in _INTRODUCING and (
        placed < 3 or _ORDERS.search(match["before"])
    ):
        return text
    return match["list"] if announces and placed > 1 else text


def _without_stays(text: str) -> str:
    """Without sentences that something stays where it is, unless they take it out of a whole."""
    parts = re.split(r"(?<=[.!?;])\s+", text)
    kept = [each for each in parts if not STAYS.match(each.strip())]
    silent = (_NONE, _STATE)
    kept = [p for p in kept if not any(each.match(p.strip()) for each in silent)] or kept
    whole = any(map(_WHOLE.search, kept))
    return text if whole or not kept or len(kept) == len(parts) else " ".join(kept)


def _introduced(text: str) -> str:
    """``There are three cups in a row: the middle one …`` → ``the middle cup …``."""
    match = _INTRODUCED.match(text)
    if match is None:
        return text
    rest = text[match.end() :]
    if not _ONE.search(rest):
        return text
    noun = singular(plain(match["noun"]))
    rest = _OTHER.sub(f"the other {noun}", _ONE.sub(lambda one: f"{one[1] or one[2]} {noun}", rest))
    return match["before"] + rest
