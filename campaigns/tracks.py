"""Tracks as Parquet files, with the unit of every column in its metadata."""

from __future__ import annotations

import io

from tracking.columns import UNITS
from tracking.metric import SCHEMA_VERSION
from tracking.track import Track


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
