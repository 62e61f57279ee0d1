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


def locks(method, element):
    """Whether it stiffens near nu = 1/2, by itself or by its element."""
    return _methods.get(method, {}).get("locks", False) or _elements.get(element, {}).get("locks", False)
