-- SPDX-License-Identifier: GPL-3.0-or-later
-- Finished attempts. Names in braces differ between SQLite and PostgreSQL: database/sql/Dialect.

CREATE TABLE attempts (
    id {row_id},
    finished_utc TEXT NOT NULL CHECK (length(finished_utc) = 20 AND finished_utc LIKE '____-__-__T__:__:__Z'),
    tooth TEXT NOT NULL CHECK (length(tooth) > 0),
    score_points INTEGER NOT NULL CHECK (score_points BETWEEN 0 AND 100),
    duration_ms {int64} NOT NULL CHECK (duration_ms >= 0),
    score_sheet_json TEXT NOT NULL,
    state_hash TEXT NOT NULL CHECK (length(state_hash) = 16),
    recording_file TEXT NOT NULL
) {table_options};

CREATE INDEX attempts_by_tooth ON attempts (tooth, finished_utc);
