-- SPDX-License-Identifier: GPL-3.0-or-later
-- Scores in tenths of a point; which lesson and rubric they belong to, and what the student had expected.

ALTER TABLE attempts ADD COLUMN score_tenths INTEGER NOT NULL DEFAULT 0 CHECK (score_tenths BETWEEN 0 AND 1000);

UPDATE attempts SET score_tenths = score_points * 10;

ALTER TABLE attempts DROP COLUMN score_points;

ALTER TABLE attempts ADD COLUMN passed INTEGER NOT NULL DEFAULT 0 CHECK (passed IN (0, 1));

ALTER TABLE attempts ADD COLUMN lesson_id TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN lesson_hash TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN rubric_hash TEXT NOT NULL DEFAULT '';

ALTER TABLE attempts ADD COLUMN expected_tenths INTEGER CHECK (expected_tenths BETWEEN 0 AND 1000);

CREATE INDEX attempts_by_lesson ON attempts (lesson_id, finished_utc);
