import pytest

from app.llm.wordpiece import WordPiece

PIECES = ["[UNK]", "[CLS]", "[SEP]", "un", "##believ", "##able", "cup", "'", "s", "!", "字", "cafe"]


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("Unbelievable cup", ["un", "##believ", "##able", "cup"]),
        ("cup's!", ["cup", "'", "s", "!"]),
        ("CAFÉ字cup", ["cafe", "字", "cup"]),
        ("unbeliever", ["[UNK]"]),
        ("[CLS]", ["[UNK]", "[UNK]", "[UNK]"]),
        ("cup\x00\tcup", ["cup", "cup"]),
        ("c" * 101, ["[UNK]"]),
        ("", []),
    ],
)
def test_words_are_divided_by_the_longest_pieces(text, pieces):
    numbers = [PIECES.index(piece) for piece in ("[CLS]", *pieces, "[SEP]")]
    assert WordPiece(PIECES).tokens(text, 100) == numbers


def test_longer_texts_are_cut_before_the_end_mark():
    assert WordPiece(PIECES).tokens("cup cup cup cup", 4) == [1, 6, 6, 2]
