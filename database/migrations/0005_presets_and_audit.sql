-- SPDX-License-Identifier: GPL-3.0-or-later
-- Hardness presets, whose versions stay; and what was done here, by whom, each row bound to the one before.

CREATE TABLE presets (
    id {row_id},
    name TEXT NOT NULL CHECK (length(name) BETWEEN 1 AND 100),
    version INTEGER NOT NULL CHECK (version > 0),
    hash TEXT NOT NULL CHECK (length(hash) = 64),
    json TEXT NOT NULL,
    author_id {int64} REFERENCES people (id),
    created_utc TEXT NOT NULL CHECK (length(created_utc) = 20),
    UNIQUE (name, version)
) {table_options};

{append_only presets};

-- hash = BLAKE2b-256 over the row before's hash and this row's other columns: database/sql/Audit.
CREATE TABLE audit (
    seq {int64} PRIMARY KEY CHECK (seq > 0),
    at_utc TEXT NOT NULL CHECK (length(at_utc) = 20),
    actor TEXT NOT NULL,
    action TEXT NOT NULL CHECK (length(action) > 0),
    object TEXT NOT NULL,
    detail TEXT NOT NULL,
    hash TEXT NOT NULL CHECK (length(hash) = 64)
) {table_options};

CREATE INDEX audit_by_object ON audit (object);

{append_only audit};

-- The newest row of the audit, signed. One row.
CREATE TABLE audit_seal (
    id INTEGER PRIMARY KEY CHECK (id = 1),
    seq {int64} NOT NULL,
    hash TEXT NOT NULL,
    -- Ed25519, hex: of the station that wrote it, and its public key
    signature TEXT NOT NULL,
    station_key TEXT NOT NULL
) {table_options};

INSERT INTO audit_seal VALUES (1, 0, '', '', '');
