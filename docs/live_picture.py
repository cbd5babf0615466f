#!/usr/bin/python3
"""live_picture.py PROGRAM FILE PICTURE: the page of `mien live` in the middle of the clip, as a PNG."""
import signal
import sys
import time

from browser import Page, start_live

FRAME = 60
program, file, picture = sys.argv[1:]
process, address = start_live(program, file, "--read-only")
page = Page(address, 1600, 1000, is_dark=True)
page.is_ready()
page.until("mienLive.state.chart.rows.length > 0")
page.run(f"const field = document.getElementById('frame'); field.value = {FRAME}; field.dispatchEvent(new Event('change'))")
page.until(f"mienLive.state.frame === {FRAME}")
page.wait_for("await mienLive.view.setToggle('guides', true)")
time.sleep(3)  # until the face is drawn finely
page.driver.save_screenshot(picture)
page.close()
process.send_signal(signal.SIGINT)
process.wait()
