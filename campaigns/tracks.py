"""Tracks as Parquet files and back, with the unit of every column in its metadata."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np

from planners.errors import InputError
from tracking.columns import UNITS
from tracking.metric import SCHEMA_VERSION
from tracking.outcome import Outcome
from tracking.track import Track


def whole_track(outcome: Outcome) -> Track:
    """The track of `outcome`; those of a fleet follow each other, with the number of each vehicle from 1 on, and its
    departure [s], in front.
    """
    fleet, one = outcome.fleet, outcome.track
    if fleet is None:
        return one
    tracks = [member.track for member in fleet.members]
    rows = [len(track) for track in tracks]
    numbers = np.repeat(np.arange(1.0, len(rows) + 1.0), rows)
    data = np.column_stack([numbers, np.repeat(fleet.departures, rows), np.concatenate([one.data for one in tracks])])
    return Track(("vehicle", "departure", *one.columns), data, one.ended, one.frame)


def ends(outcome: Outcome) -> dict[str, str]:
    """How each member of a fleet ended, as labels of the file of their tracks."""
    members = outcome.fleet.members if outcome.fleet else ()
    return {f"ended_{i}": member.track.ended for i, member in enumerate(members, start=1)}


def to_parquet(track: Track, labels: dict[str, str]) -> bytes:
    """`track` as a Parquet file; each field's metadata has its "unit", the schema's has `labels` and how it ended."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    fields = [pa.field(name, pa.float64(), metadata={"unit": UNITS.get(name, "")}) for name in track.columns]
    about = {**labels, "ended": track.ended, "schema_version": str(SCHEMA_VERSION)}
    if track.frame is not None:
        about |= {"origin_lat": repr(track.frame.lat), "origin_lon": repr(track.frame.lon)}
    table = pa.table([track.data[:, i] for i in range(len(track.columns))], pa.schema(fields, metadata=about))
    buffer = io.BytesIO()
    pq.write_table(table, buffer, compression="zstd")
    return buffer.getvalue()


def read_tracks(file: Path) -> tuple[Track, ...]:
    """The tracks in a Parquet file, one for each vehicle and without a frame.

    Raises `InputError` for a file that is damaged.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        table = pq.read_table(file)
        about = {key.decode(): value.decode() for key, value in (table.schema.metadata or {}).items()}
        data = np.column_stack([column.to_numpy() for column in table.columns])
        columns, ended = tuple(table.column_names), about["ended"]
    except (OSError, pa.ArrowException, KeyError, ValueError) as error:
        raise InputError(
            str(file), f"is not the track of a trial ({error})", "run the campaign anew: --fresh"
        ) from None
    if columns[0] != "vehicle":
        return (Track(columns, data, ended),)
    numbers = data[:, 0].astype(int)
    return tuple(
        Track(columns[2:], data[numbers == i, 2:], about.get(f"ended_{i}", ended))
        for i in range(1, int(numbers[-1]) + 1)
    )
