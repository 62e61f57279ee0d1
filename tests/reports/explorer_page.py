"""A report whose page has an explorer, made once, and what its tests do with it."""

import shutil
import sys
import tempfile
import time
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[2] / "reports")]
import browser  # noqa: E402
import springcheck_results  # noqa: E402
from program import springcheck  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402

SWEEP = """
fields = true
[[cases]]
scene = "compression"
method = ["mss-cf", "mss-nfd", "mss-affine", "fem-hencky"]
cells = [2, 2, 2]
nu = [0, 0.1, 0.2, 0.3, 0.4, 0.49]
[[cases]]
scene = "compression"
method = ["mss-cf", "mss-nfd"]
cells = [4, 4, 4]
nu = 0
deformation = ["5%", "20%"]
"""
# Runs whose commands differ from their scenes in many ways.
RUNS = [
    "torsion --method mss-cf --cells 2,2,2 --deformation 20deg --diagonal-ratio 0.5 --reference fem-hencky:q1-sri",
    "bending --method fem-stvk:q1 --cells 2,2,8 --young 3e6",
    "compression --method mss-cf --cells 2,2,2 --solver verlet --duration 0.5 --damping 0.2 --precision float",
    "compression --method fem-cauchy-born:q2 --lattice mss-affine --cells 2,2,2",
    "affine --method mss-affine --cells 2,2,2 --cell-type mixed --distortion 0.1 --seed 3 --directions 25",
    "affine --method mss-affine --cells 2,2,2 --solver verlet --duration 0.2 --distortion 0.1",
    "tissue-shearing --method mss-tissue --cells 2,2,2 --rate 0.5 --history 5 --time-steps 10",
    # Ends with half of its load.
    "tissue-relaxation --method mss-tissue --cells 2,2,2 --load-times 1,2 --load-fractions 1,0.5 --time-steps 5",
    "tissue-relaxation --method mss-tissue --cells 2,2,2 --history 0 --time-steps 5",  # less than its scene
    "tissue-oscillation --method mss-tissue --cells 2,2,2 --angular-frequency 3 --cycles 1.25",
    "traction --method mss-cf --cells 2,2,2 --traction 0,0,500 --plates sliding",
    "kidney --method mss-affine --cells 4,4,4",
    "compression --method mss-cf --cells 2,2,2 --nu 0.2 --reference fem-hencky:q1-sri",  # a second one
    "uniaxial --method mss-cf --cells 2,2,2 --deformation -5%",
    "uniaxial --method mss-cf --cells 2,2,2 --deformation -10%",
]
# Gaps between the curves of a trace are left out.
PLOTTED = (
    "return document.querySelector('.explorer .plot').data.map((trace) => {"
    "  const kept = (values) => [...values].filter((_, i) => trace.customdata[i] !== null);"
    "  const { symbol } = trace.marker;"
    "  return {name: trace.name, x: kept(trace.x), y: kept(trace.y), places: kept(trace.customdata), axis: trace.yaxis,"
    "   symbol: Array.isArray(symbol) ? kept(symbol) : symbol}; })"
)


class ExplorerPage(browser.PageTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = cls.folder / "few.h5"
        (cls.folder / "few.toml").write_text(SWEEP)
        springcheck("sweep", cls.folder / "few.toml", "--out", cls.file)
        for run in RUNS:
            springcheck("run", *run.split(), "--out", cls.file)
        springcheck("report", cls.file, "--out", cls.folder)
        cls.results = springcheck_results.read(cls.file)
        cls.cases = cls.results.cases
        cls.browser = browser.chromium(webgl=False)
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.set_size(1300, 1000)
        self.addCleanup(self.check_console)

    def open(self, address):
        self.browser.get("about:blank")
        self.browser.get((self.folder / "index.html").as_uri() + address)
        if address.startswith("#explore"):
            self.wait_for(lambda: self.drawn() > 0, "the plot is drawn")
            time.sleep(0.4)

    def drawn(self):
        return int(self.script("return document.querySelector('.explorer .plot').dataset.drawn ?? 0"))

    def choose(self, name, text):
        """Of a field of the form, as a user does."""
        before = self.drawn()
        self.script(
            "const field = document.querySelector('.explorer form').elements[arguments[0]];"
            "field.value = arguments[1]; field.dispatchEvent(new Event('change'))", name, text)
        self.wait_for(lambda: self.drawn() > before, f"{name} {text} is drawn")

    def tick(self, name, text):
        before = self.drawn()
        self.script(
            "[...document.querySelectorAll('.explorer input')].find((one) => one.name === arguments[0] &&"
            " (arguments[1] === null || one.value === arguments[1])).click()", name, text)
        self.wait_for(lambda: self.drawn() > before, f"{name} {text} is drawn")

    def key(self, place):
        return self.script("return allCases.value('key', arguments[0])", place)

    def point_at(self, trace, place):
        """Moves the mouse over a mark."""
        x, y = self.script(
            "const plot = document.querySelector('.explorer .plot'), trace = plot.data[arguments[0]];"
            "const axes = ['x', 'y'].map((one) => plot._fullLayout[trace[`${one}axis`].replace(one, `${one}axis`)]);"
            "const frame = plot.getBoundingClientRect();"
            "return [frame.left + axes[0]._offset + axes[0].d2p(trace.x[arguments[1]]),"
            " frame.top + axes[1]._offset + axes[1].d2p(trace.y[arguments[1]])]", trace, place)
        actions = ActionChains(self.browser)
        actions.w3c_actions.pointer_action.move_to_location(round(x) + 3, round(y) + 3)
        actions.w3c_actions.pointer_action.move_to_location(round(x), round(y))
        actions.perform()
        time.sleep(0.4)
        return round(x), round(y)

    def usual_over_nu(self):
        """What the explorer shows at first: the foremost methods at rest, on one mesh, under one load."""
        methods = ("mss-cf", "mss-affine", "fem-hencky")
        return {(method, nu) for method in methods for nu in (0, 0.1, 0.2, 0.3, 0.4, 0.49)}
