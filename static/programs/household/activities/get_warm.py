"""Get something warm to put on, for somebody who is cold.

Said with: am cold, i'm cold, feel cold, feeling cold, freezing, chilly, it is cold, it's cold, so cold, cold in.
"""


def get_warm():
    # grab something warm
    grab('blanket | jacket | sweater | coat | clothesjacket | towel')
