-- SPDX-License-Identifier: GPL-3.0-or-later
-- An assigned lesson belongs to the school: its content is kept here, and stations take it from here. An attempt that
-- is in doubt does not count until a teacher gives it a score.

-- hash: SHA-256 of the lesson's text, which contains its rubric. pack: that text and the files that it names.
CREATE TABLE lesson_versions (
    hash TEXT PRIMARY KEY CHECK (length(hash) = 64),
    lesson_id TEXT NOT NULL CHECK (length(lesson_id) > 0),
    version INTEGER NOT NULL CHECK (version > 0),
    pack {blob} NOT NULL
) {table_options};

{append_only lesson_versions};

-- All versions that a class was ever assigned: an attempt that was begun under an earlier one may be delivered later.
CREATE TABLE assigned_versions (
    class_id {int64} NOT NULL REFERENCES classes (id),
    lesson_id TEXT NOT NULL,
    lesson_hash TEXT NOT NULL REFERENCES lesson_versions (hash),
    PRIMARY KEY (class_id, lesson_id, lesson_hash)
) {table_options};

{append_only assigned_versions};

-- The version that new attempts are made with. Empty: assigned before versions were kept.
ALTER TABLE assignments ADD COLUMN lesson_hash TEXT NOT NULL DEFAULT '';

-- database/Doubt.h
ALTER TABLE attempts ADD COLUMN doubt TEXT NOT NULL DEFAULT '';

-- 1: a computer of a teacher or an admin has marked the recording again. 2: from before there were such checks.
ALTER TABLE attempts ADD COLUMN checked INTEGER NOT NULL DEFAULT 0 CHECK (checked IN (0, 1, 2));

UPDATE attempts SET checked = 2;

CREATE INDEX attempts_to_check ON attempts (id) WHERE checked = 0;

CREATE INDEX attempts_in_doubt ON attempts (person_id, lesson_id) WHERE doubt <> '';

CREATE INDEX attempts_by_recording ON attempts (recording_hash) WHERE recording_hash <> '';

DROP INDEX attempts_by_person;

CREATE INDEX attempts_by_person ON attempts (person_id, lesson_id, finished_utc, id, score_tenths, given_tenths,
    passed, pass_mark_tenths, duration_ms, doubt);
