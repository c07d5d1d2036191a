-- SPDX-License-Identifier: GPL-3.0-or-later
-- Who works here. uid is what the audit and files call a person by: it tells nothing about him.

CREATE TABLE people (
    id {row_id},
    uid TEXT NOT NULL UNIQUE CHECK (length(uid) = 32),
    username TEXT NOT NULL UNIQUE CHECK (length(username) BETWEEN 1 AND 64),
    given_name TEXT NOT NULL CHECK (length(given_name) <= 200),
    family_name TEXT NOT NULL CHECK (length(family_name) <= 200),
    role TEXT NOT NULL CHECK (role IN ('student', 'instructor', 'admin')),
    -- Argon2id as libsodium writes it; empty: none yet
    password_hash TEXT NOT NULL,
    -- of a one-time code; empty: none
    reset_hash TEXT NOT NULL,
    reset_until_utc TEXT NOT NULL,
    disabled INTEGER NOT NULL CHECK (disabled IN (0, 1)),
    created_utc TEXT NOT NULL CHECK (length(created_utc) = 20),
    last_login_utc TEXT NOT NULL
) {table_options};

-- By the hash of the name that was typed, also of names that nobody has: the delay tells nothing.
CREATE TABLE failed_logins (
    name_hash TEXT PRIMARY KEY,
    failures INTEGER NOT NULL CHECK (failures > 0),
    last_ms {int64} NOT NULL
) {table_options};

CREATE TABLE classes (
    id {row_id},
    name TEXT NOT NULL UNIQUE CHECK (length(name) BETWEEN 1 AND 100)
) {table_options};

-- Students of a class and those who teach it: the person's role says which.
CREATE TABLE enrolments (
    class_id {int64} NOT NULL REFERENCES classes (id),
    person_id {int64} NOT NULL REFERENCES people (id),
    PRIMARY KEY (class_id, person_id)
) {table_options};

CREATE INDEX enrolments_by_person ON enrolments (person_id);

CREATE TABLE assignments (
    id {row_id},
    class_id {int64} NOT NULL REFERENCES classes (id),
    lesson_id TEXT NOT NULL CHECK (length(lesson_id) > 0),
    -- empty: none
    due_utc TEXT NOT NULL CHECK (length(due_utc) IN (0, 20)),
    -- 0: as many as one likes
    attempt_limit INTEGER NOT NULL CHECK (attempt_limit >= 0),
    created_by {int64} NOT NULL REFERENCES people (id),
    created_utc TEXT NOT NULL CHECK (length(created_utc) = 20),
    UNIQUE (class_id, lesson_id)
) {table_options};

CREATE TABLE settings (
    -- empty: the school's; else the uid of whose it is
    owner TEXT NOT NULL,
    name TEXT NOT NULL CHECK (length(name) BETWEEN 1 AND 100),
    value TEXT NOT NULL,
    PRIMARY KEY (owner, name)
) {table_options};
