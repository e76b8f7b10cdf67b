"""The track as a table for spreadsheets and scripts."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from planners.atomic_file import atomic
from reports.files.columns import exported, header
from tracking.outcome import Outcome


def write_csv(outcome: Outcome, file: str | Path) -> None:
    """Write every column of the track, its unit in the header, angles in degrees; what is not a number stays empty.

    Where the place on the planet is known, latitude and longitude [deg] come last.
    """
    track = outcome.track
    frame = track.frame or outcome.path.frame
    names, formats = [header(column) for column in track.columns], ["%.9g"] * len(track.columns)
    columns = [exported(track, column) for column in track.columns]
    if frame is not None:
        xy = np.column_stack([track["x"], track["y"]])
        places = np.full_like(xy, np.nan)
        good = np.isfinite(xy).all(axis=1)
        if good.any():
            places[good] = frame.to_geographic(xy[good])
        names += ["latitude [deg]", "longitude [deg]"]
        formats += ["%.9f", "%.9f"]  # 0.1 mm
        columns += [places[:, 0], places[:, 1]]
    with atomic(file) as temporary, open(temporary, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(names)
        for row in np.column_stack(columns):
            writer.writerow("" if np.isnan(x) else shape % x for shape, x in zip(formats, row, strict=True))
