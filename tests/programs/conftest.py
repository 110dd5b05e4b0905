import pytest

from app.domain.action import ActionSignature, Parameter


@pytest.fixture
def grab_and_putin():
    return ActionSignature(
        name="grab_and_putin",
        parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
        meaning="Takes up one object and puts it down in another.",
    )
