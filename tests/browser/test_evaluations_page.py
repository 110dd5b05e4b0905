"""The evaluations page in Chromium, over the service as people start it."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]


def test_evaluation_is_started_watched_judged_and_found_again(open_page):
    page = open_page(viewport={"width": 360, "height": 740})
    page.get_by_role("link", name="Evaluations").click()
    page.get_by_label("Suite").select_option("tabletop")
    page.get_by_label("Planner of method 1").select_option("oracle")
    page.get_by_label("Tasks, at most").fill("4")
    page.get_by_label("Runs of each task").fill("99")
    page.get_by_role("button", name="Start").click()
    expect(page.locator('[data-field="runs"] .fault')).to_contain_text("20")
    expect(page.get_by_label("Runs of each task")).to_be_focused()

    page.reload()  # what was typed is still there
    expect(page.get_by_label("Planner of method 1")).to_have_value("oracle")
    expect(page.get_by_label("Tasks, at most")).to_have_value("4")
    page.get_by_label("Runs of each task").fill("1")
    page.get_by_role("button", name="Start").click()
    expect(page.locator("#evaluation-head .status")).to_have_text("Finished · 4 of 4 attempts")
    expect(page).to_have_url(re.compile(r"#/evaluations/ev_"))
    expect(page.locator("#tables-view tbody th").first).to_have_text("oracle")
    expect(page.locator(".attempts .mark.good")).to_have_count(4)

    page.locator(".attempts summary").first.press("Enter")
    expect(page.locator(".attempt pre")).to_contain_text("def ")
    page.get_by_label("Why, if you like").fill("it fell off")
    page.get_by_role("button", name="No, not done").click()
    expect(page.locator(".attempts .mark.bad")).to_have_count(1)
    assert page.evaluate("document.documentElement.scrollWidth") == 360

    page.reload()
    page.locator(".attempts summary").first.press("Enter")
    expect(page.get_by_label("Why, if you like")).to_have_value("it fell off")
    expect(page.get_by_role("button", name="No, not done")).to_have_attribute(
        "aria-pressed", "true"
    )
    with page.expect_download() as download:
        page.get_by_role("link", name="CSV").click()
    assert download.value.suggested_filename.endswith(".csv")
