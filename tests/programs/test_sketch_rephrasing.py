import pytest

from app.programs.sketches.rephrasing import rephrased


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        (
            "put it in the left basket... I mean, the rattan basket, please",
            "put it in the rattan basket, please",
        ),
        ("Bar the saw, the tools go in the box.", "Except for the saw, the tools go in the box."),
        ("the ball in the middle goes in the bag", "the middle ball goes in the bag"),
        ("put the ball in the middle", "put the ball in the middle"),
        (
            "Which blocks are both small and blue? Put those in it.",
            "Put all the small blue blocks in it.",
        ),
        ("the toolbox gets the tools, please", "put the tools in the toolbox, please"),
        ("the shirts get the suitcase, please", "put the shirts in the suitcase, please"),
        ("move the scarf in between the other two, please", "move the middle scarf, please"),
        ("these go in the warm wash, that is, the white hamper", "these go in the white hamper"),
        (
            "the ball on the left side of the table goes in the bag",
            "the ball on the left side goes in the bag",
        ),
        (
            "put it in the box on the left of the table",
            "put it in the box on the left of the table",
        ),
        ("the rubbish that is lying about goes in the bin", "the rubbish goes in the bin"),
        ("clear the toys scattered all over the floor into the bag", "clear the toys into the bag"),
        ("give the big case a good shove", "push the big case"),
        ("whatever's both small and purple, toss it", "all the small purple things, toss it"),
        ("now get the pear into the box", "now get the pear into the box"),
        ("Clothing gets the suitcase.", "put Clothing in the suitcase."),
        ("open up the box, pop the pear inside", "open the box, pop the pear in the box"),
        ("red on blue. The jack stays out of it.", "red on blue."),
        (
            "If it's made of glass, it goes in the crate.",
            "everything made of glass goes in the crate.",
        ),
        ("the blue pens (only the pens, mind) go in the pot", "the blue pens go in the pot"),
        (
            "half of the pens go in the pot and the other half stay here.",
            "half of the pens go in the pot.",
        ),
        (
            "put two balls in the bucket and keep the third back for me",
            "put two balls in the bucket",
        ),
        (
            "Needles: yellow tub. Paper: blue bin.",
            "put Needles in yellow tub. put Paper in blue bin.",
        ),
        (
            "Brown bread at the bottom, white on top. No ham.",
            "Brown bread at the bottom, white on top.",
        ),
        (
            "See the two jars? The glass one goes in the box; the other belongs on the tray.",
            "The glass jar goes in the box; the other jar belongs on the tray.",
        ),
        ("the drawer needs opening, then put it in", "open the drawer, then put it in"),
        ("the lid needs to be closed", "close the lid"),
        ("all goes in the bag bar the lamp", "all goes in the bag except the lamp"),
        (
            "Hand out my things: the tubes to the tray and the brushes to the jar.",
            "the tubes to the tray and the brushes to the jar.",
        ),
        (
            "Large books in the bag. The tiny ones can stay where they are.",
            "Large books in the bag.",
        ),
        ("put the green fruit, and only fruit, in the bowl", "put the green fruit in the bowl"),
        (
            "There are three tomatoes in a row: the middle one goes in the bowl.",
            "the middle tomato goes in the bowl.",
        ),
        (
            "Of my two ties, the silk one goes in the box. The other needs washing.",
            "the silk tie goes in the box. the other tie needs washing.",
        ),
        ("give the cart a bit of a push", "push the cart"),
        (
            "clear the files away, only the blue one stays where it is",
            "clear the files away except the blue one",
        ),
        (
            "The red glove goes in the bag. So does the other one, odd as it looks.",
            "The red glove goes in the bag and the other one goes in the bag, odd as it looks.",
        ),
        ("poor the cream in the jug", "pour the cream in the jug"),
        ("clear the whole desk into the box", "put everything into the box"),
        (
            "all red things go in the box, with the exception of the cup",
            "all red things go in the box except the cup",
        ),
        (
            "the left glove is torn, that's one for the bin",
            "the left glove is torn, put it in the bin",
        ),
        ("Get that fish into the ice box. The box is open.", "Get that fish into the ice box."),
        (
            "I'm after a hot dog: sausage in the bun, onion on the sausage, mustard on the onion",
            "sausage in the bun, onion on the sausage, mustard on the onion",
        ),
    ],
)
def test_what_is_said_in_a_roundabout_way_is_read_plainly(said, plain):
    assert rephrased(said) == plain


@pytest.mark.parametrize(
    "said",
    [
        "put the red block and the blue one in the box",
        "there are two cups; put both in the box",
        "put the ball in the box, not the bowl",
        "give the knife to me",
        "Put all the fruit in the bowl. The lemon stays where it is.",
        "put these things in the box: the cup and the spoon on the left",
        "My gloves are lying about again. Put them in the box.",
        "the poor cat needs its bowl on the mat",
        "",
    ],
)
def test_what_is_plain_stays_as_it_is(said):
    assert rephrased(said) == said
