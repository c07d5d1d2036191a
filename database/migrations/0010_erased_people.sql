-- SPDX-License-Identifier: GPL-3.0-or-later
-- A person can be erased. The reason why an attempt of theirs was given another score may then change to a mark, and
-- nothing else of that row.

{let_change overrides: new.reason = '[…]' AND new.id = old.id AND new.attempt_id = old.attempt_id AND
    new.author_id = old.author_id AND new.given_utc = old.given_utc AND
    COALESCE(new.given_tenths, -1) = COALESCE(old.given_tenths, -1) AND
    EXISTS (SELECT 1 FROM attempts a JOIN people p ON p.id = a.person_id
            WHERE a.id = old.attempt_id AND p.username = 'erased-' || substr(p.uid, 1, 12))};
