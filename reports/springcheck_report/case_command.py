"""The command that computes a case again."""

import json
import shlex

import numpy as np
import springcheck_results


_WITH_A_DURATION = ("load-times", "angular-frequency")  # of their own


def case_command(case, settings, scenes):
    """The command, such as "springcheck run compression --method mss-cf --nu 0.49", with the case's own
    settings where its scene has others; "" of a case that was measured. settings, scenes: of the vocabulary. What a
    scene or mesh of a user's own is called is not in the file but for its name: it stands for the path."""
    if case.kind == "measured":
        return ""
    shipped = case.scene in scenes
    own = scenes[case.scene]["values"] if shipped else {}
    method = f"{case.method}:{case.element}" if case.element else case.method
    words = ["springcheck", "run", case.scene if shipped else f"{case.scene}.toml", "--method", method]
    if case.reference:
        words += ["--reference", case.reference]
    for key, setting in settings.items():
        if not setting["option"] or not setting["column"] or key in ("method", "element"):
            continue
        if key == "duration" and any(_text(case[other]) for other in _WITH_A_DURATION):
            continue
        value = _given(case, key, setting)
        if not value and setting["kind"] != "boolean" and _text(own.get(key)):
            value = setting["default"]  # takes away what the scene asks for and the case has not
        if value and value != (_text(own[key]) if key in own else setting["default"]):
            words += [f"--{key}"] if setting["kind"] == "boolean" else [f"--{key}", value]
    return shlex.join(words)


def _given(case, key, setting):
    """As an option takes it; "" of what the case lacks."""
    components = springcheck_results.COMPONENTS.get(setting["most"], [])
    if components and setting["kind"] in ("number", "integer"):
        values = [case[f"{key}.{component}"] for component in components]
        return _text(values) if np.isfinite(np.array(values, dtype=float)).all() else ""
    return _text(case[key])


def _text(value):
    if isinstance(value, list):
        return ",".join(map(_text, value))
    if value is None or isinstance(value, str):
        return {"false": ""}.get(value, value or "")
    if isinstance(value, bool):
        return "true" if value else ""
    return json.dumps(int(value) if float(value).is_integer() else float(value)) if np.isfinite(value) else ""
