# SPDX-License-Identifier: Apache-2.0
"""Numbers of the validation pages, and the second measurement of those that are beyond their limit."""
import math

from validation import electric


def number(value, digits=6):
    if abs(value) < 1e-12:
        return "0"
    return f"{value:.{max(0, digits - 1 - math.floor(math.log10(abs(value))))}f}"


def measured(section, luxel):
    """Rows of a section; those beyond their limit are measured once more."""
    rows = section(electric.Program(luxel, 1))
    if not all(row.holds() for row in rows):
        again = section(electric.Program(luxel, 2))
        rows = [row if row.holds() else other for row, other in zip(rows, again)]
    return rows
