"""The page in Chromium, over the service as people start it."""

import io
import json
import re

import httpx
import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.physics, pytest.mark.timeout(600)]

SENTENCE = "put the banana in the bowl"


def status(page):
    return page.locator("#banner .status")


def picture(page):
    """The 3D view's pixels, (height, width, 3), once it has come to rest."""
    png = page.locator("iframe.picture").screenshot(animations="disabled")
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"), dtype=int)


def changed(one, other):
    """The share of pixels that look different."""
    return float((np.abs(one - other).max(axis=2) > 40).mean())


def slider(page):
    """Can be moved as soon as the 3D view is drawn."""
    return page.get_by_label("Moment of the rollout")


def seek(page, moment):
    """Put the slider to a moment [s] and wait until the 3D view is there."""
    slider(page).fill(str(moment))
    expect(page.locator(".controls .clock")).to_contain_text(f"{moment:.1f} /")
    page.wait_for_timeout(1500)


def duration(page):
    return float(page.locator(".controls .clock").inner_text().split()[-2])


@pytest.fixture(scope="module")
def finished(service):
    """Id of a plan that was carried out."""
    with httpx.Client(base_url=service.url, timeout=60) as http:
        request = {
            "scene": {"objects": [{"name": "banana"}, {"name": "bowl"}]},
            "instruction": SENTENCE,
            "goal": ["in(banana, bowl)"],
        }
        return http.post("/plans", json=request).json()["id"]


def test_typed_sentence_becomes_a_program_a_rollout_and_a_score(open_page):
    page = open_page(reduced_motion="no-preference")
    page.get_by_label("Scene", exact=True).select_option("banana-in-the-bowl")
    page.get_by_label("What should the robot do?").fill(SENTENCE)
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator("pre.writing")).to_contain_text("# 1: put")  # while it is being written
    expect(page.locator("ol.lines")).to_contain_text("grab_and_putin('banana', 'bowl')")
    expect(page.locator("iframe.picture")).to_be_visible()
    expect(page.locator(".lines li.lit")).to_contain_text("banana")
    expect(status(page)).to_have_text("Succeeded")
    expect(page.locator('[data-score="sr"] dd')).to_have_text("1")
    expect(page.locator(".goal .good")).to_contain_text("in(banana, bowl)")
    expect(page.locator("[data-kind=action_performed]")).to_contain_text("Done")


def test_rollout_moves_and_can_be_scrubbed(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    expect(slider(page)).to_be_enabled()
    seek(page, 0.0)
    start = picture(page)
    seek(page, round(duration(page) / 2, 1))
    moved = changed(start, picture(page))
    assert moved > 0.01
    seek(page, 0.0)
    assert changed(start, picture(page)) < moved / 3


def test_program_line_and_rollout_lead_to_each_other(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(slider(page)).to_be_enabled()
    line = page.locator(".lines li").filter(has_text="grab_and_putin")
    expect(line.locator(".mark")).to_contain_text("done")
    seek(page, 1.0)
    expect(line).to_have_attribute("aria-current", "step")
    expect(page.locator("[data-kind=execution_finished]")).to_have_class(re.compile("ahead"))
    seek(page, duration(page))
    expect(line).not_to_have_attribute("aria-current", "step")
    line.get_by_role("button").click()
    expect(page.locator(".controls .clock")).to_contain_text("0.0 /")
    expect(line).to_have_attribute("aria-current", "step")


def test_plan_is_there_after_a_restart_and_can_be_scrubbed(open_page, finished, service):
    page = open_page(f"/#/plans/{finished}")
    expect(slider(page)).to_be_enabled()
    service.stop()
    expect(slider(page)).to_be_disabled()
    service.start()
    seek(page, 2.0)  # the page has found its picture again by itself
    page.reload()
    expect(status(page)).to_have_text("Succeeded")
    expect(page.locator('[data-score="gcr"] dd')).to_have_text("1")
    expect(page.locator("#earlier-list [aria-current=page]")).to_contain_text(SENTENCE)
    expect(slider(page)).to_be_enabled()
    seek(page, 1.0)


def test_picture_that_fails_to_load_is_loaded_again(open_page, finished):
    page = open_page()
    page.route("**/viewer/*/*/", lambda route: route.abort(), times=1)
    page.goto(page.url + f"#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    expect(slider(page)).to_be_disabled()
    expect(slider(page)).to_be_enabled()
    seek(page, 1.0)


def test_skip_link_leads_to_the_result_and_keeps_it(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    expect(page.locator("#result")).to_be_focused()
    expect(status(page)).to_have_text("Succeeded")
    assert page.url.endswith(finished)


def test_task_of_an_earlier_plan_is_taken_as_it_was_asked_for(open_page, service):
    bowl = {"name": "bowl", "position": [0.5, 0.2, 0.0], "yaw": 0.5}
    scene = {"world": "tabletop", "objects": [{"name": "banana"}, bowl]}
    with httpx.Client(base_url=service.url, timeout=60) as http:
        request = {"scene": scene, "instruction": SENTENCE, "execute": False}
        plan = http.post("/plans", json=request).json()["id"]
    page = open_page(f"/#/plans/{plan}")
    page.get_by_role("button", name="Use this task").click()
    expect(page.get_by_label("What should the robot do?")).to_have_value(SENTENCE)
    assert json.loads(page.locator("#scene-json").input_value()) == scene


def test_the_other_robot_can_be_chosen_and_does_the_same(open_page):
    page = open_page()
    page.get_by_label("Scene", exact=True).select_option("banana-in-the-bowl")
    page.get_by_label("Robot", exact=True).select_option("ur5e")
    page.get_by_label("What should the robot do?").fill(SENTENCE)
    page.get_by_role("button", name="Run", exact=True).click()
    expect(status(page)).to_have_text("Succeeded")
    expect(page.locator("iframe.picture")).to_be_visible()
    page.get_by_label("Scene", exact=True).select_option("juice-by-the-bed")
    expect(page.get_by_label("Robot", exact=True)).to_be_hidden()


def test_a_vision_model_that_is_not_there_is_said_where_it_was_chosen(open_page):
    page = open_page()
    page.get_by_label("What should the robot do?").fill(SENTENCE)
    page.get_by_text("Settings").click()
    page.get_by_label("pictures are told by").select_option("vision")
    page.get_by_label("Share of objects").fill("0.5")
    page.get_by_role("button", name="Run", exact=True).click()
    field = page.locator('[data-field="perception.detector"]')
    expect(field).to_contain_text("PROGPROMPT_VISION_URL")


def test_what_was_typed_survives_a_reload(open_page):
    page = open_page()
    page.get_by_role("button", name="Add an object").click()
    page.keyboard.type("driver's cup")
    page.get_by_label("What should the robot do?").fill("bring the cup")
    page.locator("#settings-part summary").click()
    page.locator("#setting-seed").fill("7")
    page.reload()
    expect(page.locator("#object-list input").last).to_have_value("driver's cup")
    expect(page.get_by_label("What should the robot do?")).to_have_value("bring the cup")
    expect(page.locator("#settings-count")).to_have_text("1 changed")


def test_goal_of_a_ready_scene_counts_for_its_own_instruction_only(open_page):
    page = open_page()
    sentence = page.get_by_label("What should the robot do?")
    its = sentence.input_value()
    expect(page.locator("#goal-count")).not_to_have_text("none")
    sentence.fill("something else")
    expect(page.locator("#goal-count")).to_have_text("none")
    sentence.fill(its)
    expect(page.locator("#goal-count")).not_to_have_text("none")


def tab_to(page, selector):
    for _ in range(80):
        page.keyboard.press("Tab")
        if page.evaluate("selector => document.activeElement.matches(selector)", selector):
            return
    raise AssertionError(f"Tab does not lead to {selector}")


def test_keyboard_alone_is_enough(open_page):
    page = open_page()
    page.keyboard.press("Tab")
    tab_to(page, "#ready-scene")
    page.keyboard.type("Banana in")
    tab_to(page, "#instruction")
    page.keyboard.press("Control+a")
    page.keyboard.type(SENTENCE)
    page.keyboard.press("Control+Enter")
    expect(status(page)).to_have_text("Succeeded")
    expect(slider(page)).to_be_enabled()
    tab_to(page, ".lines li:nth-child(4) button")
    page.keyboard.press("Enter")
    expect(page.locator(".controls .clock")).to_contain_text("0.0 /")
    expect(page.locator(".controls .play")).to_have_text("Play")
    tab_to(page, ".controls input")
    page.keyboard.press("PageUp")
    expect(page.locator(".controls .clock")).not_to_contain_text("0.0 /")


def test_nothing_is_wider_than_a_small_phone(open_page, finished):
    for path in ("/", f"/#/plans/{finished}"):
        page = open_page(path, viewport={"width": 360, "height": 740})
        if path != "/":
            expect(page.locator('[data-score="sr"] dd')).to_have_text("1")
        for part in page.locator("#desk summary:visible").all():
            part.click()
        assert page.evaluate("document.documentElement.scrollWidth") == 360
        wider = """[...document.querySelectorAll("main *")].filter(
            (one) => one.getBoundingClientRect().right > 361).map((one) => one.outerHTML)"""
        assert page.evaluate(wider) == []


def test_errors_are_shown_at_the_fields_they_name(open_page):
    page = open_page()
    run = page.get_by_role("button", name="Run", exact=True)
    sentence = page.get_by_label("What should the robot do?")
    sentence.fill("")
    run.click()
    expect(page.locator("#instruction-field .fault")).to_contain_text("is empty")
    expect(sentence).to_be_focused()
    sentence.fill(SENTENCE)
    page.locator("#object-list input").nth(1).fill("banana")
    page.locator("#object-list input").nth(0).fill("banana")
    run.click()
    expect(page.locator("#object-list .fault").first).to_be_visible()
    page.get_by_label("Scene", exact=True).select_option("banana-in-the-bowl")
    page.locator("#goal-part summary").click()
    page.get_by_label("Conditions that should hold").fill("in(banana)")
    run.click()
    expect(page.locator("[data-field=goal] .fault")).to_contain_text("Line 1")


def test_marks_go_with_what_they_are_about(open_page):
    page = open_page()
    page.get_by_label("Scene", exact=True).select_option("juice-by-the-bed")
    page.get_by_role("button", name="as JSON").click()
    text = page.get_by_label("The scene as JSON")
    scene = text.input_value()
    text.fill(scene.replace("env0", "env7"))
    page.get_by_role("button", name="Run", exact=True).click()
    fault = page.locator(".fault")
    expect(fault).to_contain_text("there is no home 'env7'")
    expect(page.locator("#problem")).to_be_visible()
    text.fill(scene.replace("env0", "env1"))
    expect(fault).to_have_count(0)
    expect(page.locator("#problem")).to_be_hidden()


def test_scene_that_is_no_json_is_refused_and_stays_until_it_is(open_page):
    page = open_page()
    page.get_by_role("button", name="as JSON").click()
    text = page.get_by_label("The scene as JSON")
    whole = text.input_value()
    text.fill(whole[:-1])
    fault = page.locator("#scene-objects .fault")
    for name in ("Run", "Copy as curl", "as a list"):
        page.get_by_role("button", name=name, exact=True).click()
        expect(fault).to_contain_text("The scene is not JSON: ")
        expect(text).to_have_value(whole[:-1])
        expect(text).to_be_focused()
    page.reload()
    expect(text).to_have_value(whole[:-1])
    page.get_by_role("button", name="Run", exact=True).click()
    text.press("Control+End")
    text.press("}")
    expect(fault).to_have_count(0)
    page.get_by_role("button", name="as a list").click()
    expect(text).to_be_hidden()


def test_every_action_of_the_world_can_be_put_on_offer(open_page):
    page = open_page()
    count = page.locator("#action-count")
    expect(count).to_have_text("grab_and_putin")
    page.locator("#actions-part summary").press("Enter")
    page.get_by_label("pick(obj)").press("Space")
    expect(count).to_have_text("2 of 18 actions")
    expect(page.get_by_label("pick(obj)")).to_be_focused()
    scene = page.locator("#scene-json")
    assert json.loads(scene.input_value())["actions"] == ["grab_and_putin", "pick"]
    page.reload()
    expect(count).to_have_text("2 of 18 actions")
    page.locator("#actions-part summary").click()
    page.get_by_role("button", name="All", exact=True).click()
    expect(count).to_have_text("18 of 18 actions")
    page.get_by_role("button", name="Usual", exact=True).click()
    assert "actions" not in json.loads(scene.input_value())
    page.get_by_label("Scene", exact=True).select_option("juice-by-the-bed")
    expect(count).to_have_text("11 of 41 actions")


def test_home_is_chosen_from_the_catalogue_and_tells_its_rooms(open_page):
    page = open_page()
    expect(page.get_by_label("Home", exact=True)).to_be_hidden()
    page.get_by_label("Scene", exact=True).select_option("juice-by-the-bed")
    page.locator("#rooms-part summary").click()
    rooms = page.locator("#room-list")
    expect(rooms).to_contain_text("fridge")
    expect(rooms).not_to_contain_text("childrensroom")
    page.get_by_label("Home", exact=True).select_option("env1")
    expect(rooms).to_contain_text("childrensroom")
    assert json.loads(page.locator("#scene-json").input_value())["environment"] == "env1"


def test_question_back_is_no_failure_anywhere(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    page.get_by_text("Settings").click()
    page.get_by_label("Planner", exact=True).select_option("situated")
    page.get_by_label("And then?").fill("swap them")  # does not say which
    page.get_by_role("button", name="Go on").click()
    expect(status(page)).to_have_text("Asked back, nothing was moved")
    expect(page.locator("#earlier-list [aria-current=page]")).to_contain_text("asked back")
    expect(page.locator("#earlier-list [aria-current=page] .dot")).to_have_class("dot warn")
    expect(page.locator("[data-kind=asked]")).to_contain_text("Asked back")
    expect(page.locator("#program-view")).to_have_text("Nothing was planned.")
    expect(page.locator(".caret")).to_have_count(0)
    expect(page.locator("#scores-view")).to_contain_text("nothing to score")


def test_reply_field_suggests_what_would_be_understood(open_page, service, finished):
    scene = {"objects": [{"name": "banana"}, {"name": "bowl"}, {"name": "pear"}]}
    with httpx.Client(base_url=service.url, timeout=60) as http:
        request = {"scene": scene, "instruction": SENTENCE, "execute": False}
        plan = http.post("/plans", json=request).json()["id"]
    page = open_page(f"/#/plans/{plan}")
    reply = page.locator("#next")
    expect(reply).to_have_attribute("placeholder", "now the pear")
    page.goto(f"{service.url}/#/plans/{finished}")
    expect(reply).to_have_attribute("placeholder", "say what comes next")  # all has been moved

    choices = ["put the red block in the bowl", "put the blue block in the bowl"]
    declined = {"kind": "ambiguous", "reason": "", "question": "Which?", "choices": choices}

    def ask(route):
        content = route.fetch().json() | {"status": "failed", "declined": declined}
        route.fulfill(json=content)

    page.route(f"**/plans/{plan}", ask)
    page.goto(f"{service.url}/#/plans/{plan}")
    expect(reply).to_have_attribute("placeholder", choices[0])
    page.unroute_all(behavior="ignoreErrors")


def test_what_comes_of_run_is_brought_into_view(open_page):
    page = open_page(viewport={"width": 1280, "height": 700})
    page.locator("#settings-part summary").click()
    page.get_by_label("Ask me before it is carried out").check()
    page.get_by_label("What should the robot do?").fill(SENTENCE)
    page.get_by_role("button", name="Run", exact=True).click()
    expect(status(page)).to_be_in_viewport()
    expect(status(page)).to_have_text("Waiting for your approval")
    expect(page.get_by_role("button", name="Approve and run")).to_be_in_viewport()


def test_typed_sentence_is_kept_when_another_scene_is_chosen(open_page):
    page = open_page()
    sentence = page.get_by_label("What should the robot do?")
    page.get_by_label("Scene", exact=True).select_option("banana-in-the-bowl")
    expect(sentence).to_have_value(SENTENCE)  # one ready sentence gives way to another
    sentence.fill("tidy up, please")
    page.get_by_label("Scene", exact=True).select_option("dinner-table")
    expect(sentence).to_have_value("tidy up, please")
    expect(page.locator("#goal-count")).to_have_text("none")


def test_service_that_goes_away_is_told_where_it_is_missed(open_page, service):
    page = open_page()
    page.get_by_label("What should the robot do?").fill("go on forever")
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator("pre.writing")).to_contain_text("on and on")
    service.stop()
    missed = page.locator("#banner .problem")
    expect(missed).to_contain_text("The service cannot be reached")
    expect(page.locator("#readiness")).to_have_attribute("data-state", "gone")
    expect(page.locator("#banner .clock")).to_be_hidden()
    service.start()
    expect(missed).to_be_hidden()
    expect(page.locator("#readiness")).not_to_have_attribute("data-state", "gone")
    page.get_by_role("button", name="Cancel").click()
    expect(status(page)).to_have_text("Cancelled")


def test_changed_run_says_so_and_marks_its_own_lines(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    page.locator("#whatif summary").click()
    page.get_by_label("From line").fill("9")
    page.get_by_role("button", name="Run it so").click()
    fault = page.locator('#whatif [data-field="line"] .fault')
    expect(fault).to_contain_text("give 1 to ")
    page.get_by_label("From line").fill("")
    expect(fault).to_have_count(0)
    program = "def task():\n    grab_and_putin('banana', 'bowl')\n"
    page.locator("#whatif-program").fill(program)
    page.get_by_role("button", name="Run it so").click()
    expect(page.locator("#banner .why")).to_contain_text("another program than planned")
    expect(status(page)).to_have_text("Succeeded")
    expect(page.locator("#whatif")).to_be_visible()  # everything is over
    expect(page.locator('.lines [data-line="2"]')).to_have_attribute("data-state", "performed")
    expect(page.locator(".lines li")).to_have_count(2)
    expect(page.locator(".usage")).to_have_count(0)  # no model wrote it


def test_without_motion_a_finished_run_shows_its_end(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(slider(page)).to_be_enabled()
    expect(page.locator(".controls .play")).to_have_text("Replay")
    assert float(slider(page).input_value()) > duration(page) - 0.1


def test_labels_stand_beside_their_boxes_and_the_chosen_way_stands_out(open_page):
    page = open_page(viewport={"width": 1280, "height": 700}, color_scheme="dark")
    page.locator("#settings-part summary").click()
    for box in page.locator("#settings .check").all():
        [tick, label] = [box.locator(part).bounding_box() for part in ("input", "label")]
        assert label["x"] > tick["x"] + tick["width"]
    background = "one => getComputedStyle(one).backgroundColor"
    [chosen, other] = [page.locator(".switch label").nth(n).evaluate(background) for n in (0, 1)]
    [red, green, blue] = map(int, re.findall(r"\d+", chosen))
    assert chosen != other
    assert green > max(red, blue)  # not one grey beside another


def test_running_plan_can_be_cancelled(open_page):
    page = open_page()
    page.get_by_label("What should the robot do?").fill("go on forever")
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator("pre.writing")).to_contain_text("on and on")
    page.get_by_role("button", name="Cancel").click()
    expect(status(page)).to_have_text("Cancelled")


def test_step_that_was_stopped_is_no_longer_under_way(open_page, service):
    cup = {"name": "cup", "position": [0.5, -0.15, 0.0], "properties": {"contents": "beads"}}
    bowl = {"name": "bowl", "position": [0.5, 0.2, 0.0]}
    request = {
        "scene": {"objects": [cup, bowl], "actions": ["pour"]},
        "instruction": "pour the cup into the bowl",
        "program": "def task():\n    pour('cup', 'bowl')\n",  # takes the longest of all
    }
    with httpx.Client(base_url=service.url, timeout=60) as http:
        plan = http.post("/plans", json=request).json()["id"]
    page = open_page(f"/#/plans/{plan}")
    expect(page.locator(".lines [data-state=running]")).to_have_count(1)
    page.get_by_role("button", name="Cancel").click()
    expect(page.locator(".lines [data-state=stopped]")).to_have_count(1)


def test_failed_plan_says_why(open_page):
    page = open_page()
    page.get_by_label("What should the robot do?").fill("say nothing")
    page.get_by_role("button", name="Run", exact=True).click()
    expect(status(page)).to_have_text("Failed")
    expect(page.locator("#banner .why")).to_contain_text("the model said nothing")


def test_rejected_call_is_marked_in_the_program(open_page):
    page = open_page()
    page.get_by_label("Scene", exact=True).select_option("banana-in-the-bowl")
    page.get_by_label("What should the robot do?").fill("put the banana in the vase")
    page.locator("#goal-part summary").click()
    page.get_by_label("Conditions that should hold").fill("in(banana, bowl)")
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator(".lines [data-state=skipped] .note")).to_contain_text("'vase'")
    expect(page.locator('[data-score="exec"] dd')).to_have_text("0")
    expect(page.locator('[data-score="sr"] dd')).to_have_text("0")


def test_program_written_by_hand_is_checked_then_run(open_page):
    page = open_page()
    page.get_by_label("Scene", exact=True).select_option("banana-in-the-bowl")
    page.get_by_text("Program by hand").click()
    program = "def task():\n    grab_and_putin('banana', 'vase')\n"
    page.locator("#program").fill(program)
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator("#program-field .fault")).to_contain_text("there is no object 'vase'")
    page.locator("#program").fill(program.replace("vase", "bowl"))
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator(".lines li")).to_have_count(2)
    expect(page.locator("#banner")).to_contain_text("Program by hand")


def test_dialogue_goes_on_from_where_a_plan_ended(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    page.get_by_label("And then?").fill("and rest now")
    page.reload()
    expect(page.get_by_label("And then?")).to_have_value("and rest now")  # nothing typed is lost
    page.get_by_role("button", name="Go on").click()
    expect(page.locator("#banner .sentence")).to_have_text("and rest now")
    expect(status(page)).to_have_text("Succeeded")
    page.get_by_role("link", name="The plan before").click()
    expect(page.locator("#banner .sentence")).to_have_text(SENTENCE)


def test_a_trace_of_many_parts_is_one_file(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    # As if a part had three events only.
    page.route(
        re.compile(r"/trace\?limit=1000"),
        lambda route: route.continue_(url=route.request.url.replace("limit=1000", "limit=3")),
    )
    with page.expect_download() as download:
        page.get_by_role("button", name="Trace").click()
    items = json.loads(download.value.path().read_text())["items"]
    assert [event["sequence"] for event in items] == list(range(len(items)))
    assert items[-1]["kind"] == "execution_finished"
    assert download.value.suggested_filename.startswith("ex_")


def test_a_run_can_be_repeated_and_compared(open_page, finished):
    page = open_page(f"/#/plans/{finished}")
    expect(status(page)).to_have_text("Succeeded")
    page.locator("#whatif summary").click()
    page.get_by_role("button", name="Repeat unchanged and compare").click()
    expect(page.locator("#banner .why")).to_contain_text("bit for bit")
