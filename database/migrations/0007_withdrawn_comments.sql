-- SPDX-License-Identifier: GPL-3.0-or-later
-- A comment can be taken back by who wrote it. Its words stay, and nobody is shown them any more.

-- Null: it stands.
ALTER TABLE comments ADD COLUMN withdrawn_utc TEXT CHECK (length(withdrawn_utc) = 20);
