"""Settings of Sphinx; the site is built by scripts/docs.sh."""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "_extensions"))

project = "springcheck"
author = copyright = "The springcheck maintainers"
version = release = re.search(r"project\(springcheck VERSION ([\d.]+)",
                              (HERE.parent / "CMakeLists.txt").read_text())[1]
extensions = ["myst_parser", "sphinx.ext.imgmath", "springcheck_program"]
exclude_patterns = ["_extensions"]
myst_enable_extensions = ["dollarmath", "deflist", "colon_fence"]
myst_heading_anchors = 3
smartquotes = False  # a quote and -- are what one types
html_theme = "furo"
html_title = f"springcheck {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_copy_source = False
# Formulas are pictures in the page, so that it needs no network and no script.
imgmath_image_format = "svg"
imgmath_embed = True
imgmath_font_size = 15
# The headers' reference is made by Doxygen beside the site.
linkcheck_ignore = [r"^\.\./api/", r"^api/"]
linkcheck_timeout = 20
linkcheck_retries = 2
