-- SPDX-License-Identifier: GPL-3.0-or-later
-- Attempts have an owner, a number of their own that no other station gives, and all that says how they were made.

-- A score sheet is some kilobytes; lists of attempts are read without it.
CREATE TABLE score_sheets (
    attempt_id {int64} PRIMARY KEY REFERENCES attempts (id),
    json TEXT NOT NULL
) {table_options};

INSERT INTO score_sheets SELECT id, score_sheet_json FROM attempts;

ALTER TABLE attempts DROP COLUMN score_sheet_json;

ALTER TABLE attempts DROP COLUMN recording_file;

-- Nobody: made before there were people.
ALTER TABLE attempts ADD COLUMN person_id {int64} REFERENCES people (id);

ALTER TABLE attempts ADD COLUMN uid TEXT NOT NULL DEFAULT '';

-- What an instructor gave instead of the machine's score, which stays.
ALTER TABLE attempts ADD COLUMN given_tenths INTEGER CHECK (given_tenths BETWEEN 0 AND 1000);

-- An instructor's score passes from here on.
ALTER TABLE attempts ADD COLUMN pass_mark_tenths INTEGER NOT NULL DEFAULT 0 CHECK (pass_mark_tenths >= 0);

ALTER TABLE attempts ADD COLUMN device TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN method TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN grid INTEGER NOT NULL DEFAULT 0 CHECK (grid >= 0);

ALTER TABLE attempts ADD COLUMN view_mode TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN seed TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN preset TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN preset_hash TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN program TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN mean_force_mn INTEGER NOT NULL DEFAULT 0 CHECK (mean_force_mn >= 0);

ALTER TABLE attempts ADD COLUMN peak_force_mn INTEGER NOT NULL DEFAULT 0 CHECK (peak_force_mn >= 0);

-- [[criterion, tenths lost, tenths there were], ...]: of the score sheet, for charts
ALTER TABLE attempts ADD COLUMN criteria_json TEXT NOT NULL DEFAULT '[]';

-- Of the recording's bytes, 64 hex digits; empty: not kept
ALTER TABLE attempts ADD COLUMN recording_hash TEXT NOT NULL DEFAULT '';

UPDATE attempts SET uid = 'legacy-' || id;

CREATE UNIQUE INDEX attempts_by_uid ON attempts (uid);

CREATE INDEX attempts_by_person ON attempts (person_id, lesson_id, finished_utc);

-- Kept along with the attempts, in the same transaction, so that a class of hundreds is read at once.
CREATE TABLE standings (
    person_id {int64} NOT NULL REFERENCES people (id),
    lesson_id TEXT NOT NULL,
    attempts INTEGER NOT NULL CHECK (attempts > 0),
    best_tenths INTEGER NOT NULL CHECK (best_tenths BETWEEN 0 AND 1000),
    passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
    last_utc TEXT NOT NULL CHECK (length(last_utc) = 20),
    PRIMARY KEY (person_id, lesson_id)
) {table_options};

-- Where a server keeps them; beside a file they lie in a folder.
CREATE TABLE recordings (
    hash TEXT PRIMARY KEY CHECK (length(hash) = 64),
    content {blob} NOT NULL
) {table_options};

CREATE TABLE comments (
    id {row_id},
    attempt_id {int64} NOT NULL REFERENCES attempts (id),
    author_id {int64} NOT NULL REFERENCES people (id),
    written_utc TEXT NOT NULL CHECK (length(written_utc) = 20),
    words TEXT NOT NULL CHECK (length(words) BETWEEN 1 AND 4000),
    -- in the tooth's frame, micrometres; all null: to no place
    x_um INTEGER,
    y_um INTEGER,
    z_um INTEGER,
    -- since the attempt began; null: to no moment
    moment_ms {int64}
) {table_options};

CREATE INDEX comments_by_attempt ON comments (attempt_id);

CREATE TABLE overrides (
    id {row_id},
    attempt_id {int64} NOT NULL REFERENCES attempts (id),
    author_id {int64} NOT NULL REFERENCES people (id),
    given_utc TEXT NOT NULL CHECK (length(given_utc) = 20),
    -- null: the machine's score counts again
    given_tenths INTEGER CHECK (given_tenths BETWEEN 0 AND 1000),
    reason TEXT NOT NULL CHECK (length(reason) BETWEEN 1 AND 4000)
) {table_options};

CREATE INDEX overrides_by_attempt ON overrides (attempt_id);

{append_only overrides};
