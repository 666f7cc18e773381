# SPDX-License-Identifier: Apache-2.0
"""Progress on a bar."""


class ProgressBar:
    """A progress function that draws on a bar such as tqdm's: bake(path, progress=ProgressBar(tqdm)).

    make: tqdm.tqdm, tqdm.auto.tqdm, or anything that is called with total=100 and has set_description(), update(),
    refresh() and close(). One bar per stage.
    """

    def __init__(self, make):
        self._make = make
        self._bar = None
        self._stage = None
        self._shown = 0.0

    def __call__(self, stage, done, rays, error):
        if stage != self._stage:
            self.close()
            self._bar = self._make(total=100)
            self._bar.set_description(stage)
            self._stage, self._shown = stage, 0.0
        now = round(100.0 * min(max(done, 0.0), 1.0), 1)
        if now > self._shown:
            self._bar.update(now - self._shown)
            self._shown = now
        if error > 0.0 and hasattr(self._bar, "set_postfix_str"):
            self._bar.set_postfix_str(f"error {100.0 * error:.2g} %")
        return True

    def close(self):
        """Ends the bar that is drawn."""
        if self._bar is not None:
            self._bar.close()
            self._bar = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
