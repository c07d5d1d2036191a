-- SPDX-License-Identifier: GPL-3.0-or-later
-- Exams that were begun. Who ends the program, or begins again, before there is a score has had his attempt all the same.

CREATE TABLE exam_starts (
    uid TEXT PRIMARY KEY CHECK (length(uid) = 32),
    person_id {int64} NOT NULL REFERENCES people (id),
    lesson_id TEXT NOT NULL CHECK (length(lesson_id) > 0),
    begun_utc TEXT NOT NULL CHECK (length(begun_utc) = 20)
) {table_options};

CREATE INDEX exam_starts_by_person ON exam_starts (person_id, lesson_id, begun_utc);

{append_only exam_starts};
