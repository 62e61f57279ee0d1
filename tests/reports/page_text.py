"""What a page of a report says, read as text."""

import re
from html import unescape


def section(page, name):
    """The HTML of a section, None where the page has none."""
    found = re.search(rf'<section id="{re.escape(name)}">.*?</section>', page, re.DOTALL)
    return found and found.group()


def numbers(html):
    """Of every <data>: its attributes, and `text`."""
    found = []
    for attributes, text in re.findall(r"<data ([^>]*)>([^<]*)</data>", html):
        pairs = {name: unescape(value) for name, value in re.findall(r'([\w-]+)="([^"]*)"', attributes)}
        found.append({**pairs, "text": text})
    return found


def rows(html, table):
    """Texts of a table's body, row by row."""
    body = re.search(rf'<table id="table-{re.escape(table)}".*?<tbody>(.*?)</tbody>', html, re.DOTALL)
    cells = [re.findall(r"<td[^>]*>(.*?)</td>", row) for row in body.group(1).split("</tr>")]
    return [[unescape(re.sub("<[^>]*>", "", cell)) for cell in row] for row in cells if row]


def figures(html):
    return re.findall(r'<figure id="figure-([^"]*)">', html)
