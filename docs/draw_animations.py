"""Draw the pictures of docs/animation.md again: ``python docs/draw_animations.py``.

The film needs nothing more than the package; the picture of the player needs selenium, Chromium and
its driver.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

from planar_planner import Planner
from planar_planner.films.film import write_film
from planar_planner.films.material import Material, gather
from planar_planner.films.pace import Pace
from planar_planner.films.page import write_page

PICTURES = Path(__file__).parent / "pictures"
WINDOW = (1180, 640)
SHARE = 0.45  # of the travel at which the player is shown


def main() -> int:
    """Draw both; 1 without a browser."""
    planner = Planner("gear")
    material = gather(planner, planner.solve())
    pace = Pace(seconds=4.0, fps=12.5, hold=0.8)
    film = PICTURES / "gear.gif"
    write_film(material, film, suffix=".gif", pace=pace, size=(360, 360))
    print(film)
    browser, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if browser is None or driver is None:
        print("no chromium with chromedriver: player.png stays as it is", file=sys.stderr)
        return 1
    photograph(material, browser, driver, PICTURES / "player.png")
    print(PICTURES / "player.png")
    return 0


def photograph(material: Material, browser: str, driver: str, picture: Path) -> None:
    """Open the page in a headless browser, go to a share of the way, take the picture."""
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        page = Path(folder) / "page.html"
        write_page(material, page, Pace())
        for flag in ("--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"):
            options.add_argument(flag)
        options.add_argument(f"--user-data-dir={folder}/profile")
        options.add_argument("--force-prefers-reduced-motion")
        chrome = webdriver.Chrome(options=options, service=Service(driver))
        try:
            size = {"width": WINDOW[0], "height": WINDOW[1], "deviceScaleFactor": 1}
            chrome.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size | {"mobile": False})
            chrome.get(page.as_uri())
            chrome.execute_async_script(
                "const [share, done] = arguments;"
                "const scrub = document.getElementById('scrub');"
                "scrub.value = share; scrub.dispatchEvent(new Event('input'));"
                "requestAnimationFrame(() => requestAnimationFrame(() => done()));",
                SHARE,
            )
            chrome.save_screenshot(str(picture))
        finally:
            chrome.quit()


if __name__ == "__main__":
    sys.exit(main())
