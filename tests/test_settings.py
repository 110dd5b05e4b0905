from pathlib import Path

import pytest

from app.main.models import llm_config
from app.settings import Settings


def test_every_setting_survives_the_way_through_the_environment():
    settings = Settings(
        host="0.0.0.0",
        port=81,
        data_dir=Path("/data"),
        model="small",
        threads=3,
        scripted=Path("x"),
    )
    assert Settings.from_environment(settings.to_environment()) == settings


def test_an_empty_variable_counts_as_not_set():
    assert Settings.from_environment({"PROGPROMPT_PORT": " "}).port == 8000


def test_a_port_that_is_no_number_is_refused_by_the_name_of_its_variable():
    with pytest.raises(ValueError, match="PROGPROMPT_PORT is 'http'"):
        Settings.from_environment({"PROGPROMPT_PORT": "http"})


def test_the_database_lies_in_the_data_directory_unless_a_url_is_given():
    assert Settings(data_dir=Path("/data")).database == "sqlite:////data/progprompt.sqlite"
    assert Settings(database_url="postgresql://x/y").database == "postgresql://x/y"


def test_a_switch_is_true_or_false():
    assert Settings.from_environment({"PROGPROMPT_ENDPOINT_CHAT": "True"}).endpoint_chat
    with pytest.raises(ValueError, match="PROGPROMPT_ENDPOINT_CHAT is 'yes'; true or false"):
        Settings.from_environment({"PROGPROMPT_ENDPOINT_CHAT": "yes"})


def test_services_of_the_settings_are_models():
    settings = Settings(
        endpoint_url="http://llm.test/v1",
        endpoint_chat=True,
        anthropic_model="big",
        anthropic_key="secret",
    )
    (_, ours), (name, theirs) = llm_config(settings).endpoints
    assert (ours.protocol, ours.chat) == ("openai", True)
    assert (name, theirs.protocol, theirs.model, theirs.key) == (
        "anthropic",
        "anthropic",
        "big",
        "secret",
    )
    assert "secret" not in repr(theirs)
