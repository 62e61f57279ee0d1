"""What the program tells of its methods and elements (data/vocabulary.json, as `springcheck list
methods`, `elements` and `settings` print it). Others, which a user measured, are not known here."""

_methods, _elements, _settings = {}, {}, {}


def learn(vocabulary):
    """Before anything is asked."""
    _methods.update(vocabulary["methods"])
    _elements.update(vocabulary["elements"])
    _settings.update(vocabulary["settings"])


def family(method):
    """ "springs" or "finite elements"; None of a method that is not known."""
    return _methods.get(method, {}).get("family")


def foremost(family):
    """Its methods that people want to see first, in that order."""
    places = {name: entry["foremost"] for name, entry in _methods.items() if entry["family"] == family}
    return sorted((name for name, place in places.items() if place), key=places.get)


def of_thesis():
    """The springs that the thesis is of: figures of what it shows of its own are theirs."""
    return _of_thesis("springs")


def reference_law():
    """The finite elements that springs are compared with first: the thesis's own reference."""
    return _of_thesis("finite elements")


def _of_thesis(family):
    return next(
        name for name, entry in _methods.items() if entry["family"] == family and entry["of_thesis"]
    )


def place(method):
    """Its place among those of its family, for sorting; others come behind."""
    return _methods.get(method, {}).get("foremost") or len(_methods)


def law(method):
    """Of the material, "" where the method is not known by it."""
    return _methods.get(method, {}).get("law", "")


def bar_limit(method):
    """Compression at which a bar of its law bears most, 0 where there is none, and in words."""
    limit = _methods.get(method, {}).get("bar_limit", {"strain": 0, "words": ""})
    return limit["strain"], limit["words"]


def at_rest(name):
    """The statics of a method that steps, by their name in tables, of its element where they name
    none; other methods are their own."""
    method, colon, element = name.partition(":")
    rest = _methods.get(method, {}).get("at_rest")
    if not rest:
        return name
    return rest if ":" in rest else rest + colon + element


def corrects_volume():
    """Springs with a volume correction throughout."""
    return [name for name, entry in _methods.items() if entry["corrects_volume"]]


def reads(method, setting):
    return setting in _methods.get(method, {}).get("settings", [])


def own_solver(method):
    """The solver when none is named."""
    return _methods[method]["solvers"][0] if method in _methods else "static"


def look(method):
    """Colour and matplotlib's marker; None of a method that is not known."""
    entry = _methods.get(method)
    return entry and (entry["colour"], entry["mark"])


def default(setting):
    """The value of a setting that is not named."""
    return _settings[setting]["default"]


def variants():
    """Settings that names of methods tell where they are not the default, and how."""
    return {name: entry["variant"] for name, entry in _settings.items() if entry["variant"]}


def locks(method, element):
    """Whether it stiffens near nu = 1/2, by itself or by its element."""
    return _methods.get(method, {}).get("locks", False) or _elements.get(element, {}).get("locks", False)
