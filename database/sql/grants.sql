-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an account of stations may do in a school on PostgreSQL. The account that owns the tables runs this, after each
-- migration again; it may be run any number of times. {station} is the account of the stations.
--
-- A person proves who they are by the hash of their password, which the station computes from the password and the
-- salt. The server answers with a token. A connection that has set the token acts for this person: the functions and
-- the policies below ask cusp_person() and cusp_role(). A function "cusp_inner_..." is for the other functions only,
-- and runs with the rights of its caller: nobody gains by calling it, should the privileges be lost in a restore.

SELECT pg_catalog.set_config('search_path', (SELECT pg_catalog.quote_ident(n.nspname) FROM pg_catalog.pg_class c
    JOIN pg_catalog.pg_namespace n ON n.oid OPERATOR(pg_catalog.=) c.relnamespace
    WHERE c.relname OPERATOR(pg_catalog.=) 'cusp_schema' AND pg_catalog.pg_table_is_visible(c.oid))
    OPERATOR(pg_catalog.||) ', pg_temp', true);

DO $$
DECLARE
    one record;
BEGIN
    IF (SELECT tableowner FROM pg_tables WHERE schemaname = current_schema() AND tablename = 'people')
        IS DISTINCT FROM current_user THEN
        RAISE EXCEPTION 'only the account that owns the tables may grant rights on them';
    END IF;
    SELECT r.rolsuper OR r.rolbypassrls OR pg_has_role(r.oid, current_user, 'MEMBER') AS is_free INTO one
        FROM pg_roles r WHERE r.rolname = '{name}';
    IF one.is_free IS NULL THEN
        RAISE EXCEPTION 'there is no account {name} on the server; create it first';
    ELSIF one.is_free THEN
        RAISE EXCEPTION 'the account {name} may do everything here; choose one that owns nothing';
    END IF;
    -- Removes what an earlier version of this text made: policies before the functions that they call.
    FOR one IN
        SELECT format('DROP POLICY %I ON %I', policyname, tablename) AS line FROM pg_policies
            WHERE schemaname = current_schema() AND starts_with(policyname::text, 'cusp_')
        UNION ALL SELECT format('DROP FUNCTION %s', p.oid::regprocedure) FROM pg_proc p
            WHERE p.pronamespace = current_schema()::regnamespace AND starts_with(p.proname::text, 'cusp_')
        ORDER BY line DESC
    LOOP
        EXECUTE one.line;
    END LOOP;
    -- The account that had the rights until now loses them.
    CREATE TABLE IF NOT EXISTS cusp_grants (station text NOT NULL, schema integer NOT NULL);
    FOR one IN SELECT r.rolname AS name FROM cusp_grants g JOIN pg_roles r ON r.rolname = g.station
        UNION SELECT '{name}'
    LOOP
        EXECUTE format('REVOKE ALL ON ALL TABLES IN SCHEMA %I FROM PUBLIC, %I', current_schema(), one.name);
        EXECUTE format('REVOKE ALL ON ALL SEQUENCES IN SCHEMA %I FROM PUBLIC, %I', current_schema(), one.name);
    END LOOP;
    EXECUTE format('REVOKE ALL ON SCHEMA %I FROM {station}', current_schema());
    EXECUTE format('REVOKE CREATE ON SCHEMA %I FROM PUBLIC', current_schema());
    EXECUTE format('REVOKE TEMPORARY ON DATABASE %I FROM PUBLIC', current_database());
    -- Until PostgreSQL 14, a superuser owns the schema, and everybody may add functions that others then call.
    IF has_schema_privilege('{name}', current_schema(), 'CREATE') THEN
        RAISE EXCEPTION '{name} may create functions in the schema %, which others then call unknowingly; let a '
            'superuser say: ALTER SCHEMA % OWNER TO %', current_schema(), current_schema(), current_user;
    END IF;
    EXECUTE format('GRANT USAGE ON SCHEMA %I TO {station}', current_schema());
END $$;

-- Otherwise each station could read the statements of the others, with their proofs. Only a superuser can set it.
DO $$
BEGIN
    ALTER ROLE {station} SET track_activities = off;
EXCEPTION WHEN insufficient_privilege THEN
    NULL;
END $$;

DELETE FROM cusp_grants;

INSERT INTO cusp_grants SELECT '{name}', max(version) FROM cusp_schema;

CREATE TABLE IF NOT EXISTS cusp_sessions (
    token_hash text PRIMARY KEY,
    person_id bigint NOT NULL REFERENCES people (id),
    until timestamptz NOT NULL
);

-- Who asks.

CREATE FUNCTION cusp_inner_digest(words text) RETURNS text LANGUAGE sql IMMUTABLE SET search_path FROM CURRENT AS $$
    SELECT encode(sha256(convert_to(words, 'UTF8')), 'hex')
$$;

CREATE FUNCTION cusp_inner_now() RETURNS text LANGUAGE sql STABLE SET search_path FROM CURRENT AS $$
    SELECT to_char(now() AT TIME ZONE 'UTC', 'YYYY-MM-DD"T"HH24:MI:SS"Z"')
$$;

CREATE FUNCTION cusp_inner_refuse() RETURNS void LANGUAGE plpgsql SET search_path FROM CURRENT AS $$
BEGIN
    RAISE EXCEPTION 'the person who is logged in may not do that' USING ERRCODE = 'insufficient_privilege';
END $$;

-- Whether a hash can be a password's: as the program makes them, and at a cost that it computes.
CREATE FUNCTION cusp_inner_is_hash(words text) RETURNS boolean LANGUAGE sql IMMUTABLE SET search_path FROM CURRENT AS $$
    SELECT COALESCE(length(words) < 128 AND words ~ '^\$argon2id\$v=19\$m=[0-9]+,t=[0-9]+,p=1\$[A-Za-z0-9+/]+\$[A-Za-z0-9+/]+$'
        AND substring(words FROM 'm=([0-9]+),')::numeric <= {most_kib}
        AND substring(words FROM ',t=([0-9]+),')::numeric <= {most_passes}
        AND length(split_part(words, '$', 5)) = 22 AND length(split_part(words, '$', 6)) = 43, false)
$$;

CREATE FUNCTION cusp_person() RETURNS bigint LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT p.id FROM cusp_sessions s JOIN people p ON p.id = s.person_id
        WHERE s.token_hash = cusp_inner_digest(current_setting('cusp.token', true)) AND s.until > now()
            AND p.disabled = 0
$$;

CREATE FUNCTION cusp_role() RETURNS text LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT role FROM people WHERE id = cusp_person()
$$;

CREATE FUNCTION cusp_uid() RETURNS text LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT uid FROM people WHERE id = cusp_person()
$$;

CREATE FUNCTION cusp_classes() RETURNS SETOF bigint LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT
AS $$
    SELECT class_id FROM enrolments WHERE person_id = cusp_person()
$$;

-- Whose attempts the person may read: their own, and an instructor those of their classes. An admin reads all.
CREATE FUNCTION cusp_reach() RETURNS SETOF bigint LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT
AS $$
    SELECT cusp_person()
    UNION SELECT e.person_id FROM enrolments e WHERE e.class_id IN (SELECT cusp_classes()) AND cusp_role() = 'instructor'
$$;

-- Whose names the person may read: also of those who said something of these attempts.
CREATE FUNCTION cusp_shown() RETURNS SETOF bigint LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT
AS $$
    SELECT cusp_reach()
    UNION SELECT c.author_id FROM comments c JOIN attempts a ON a.id = c.attempt_id
        WHERE a.person_id IN (SELECT cusp_reach())
    UNION SELECT o.author_id FROM overrides o JOIN attempts a ON a.id = o.attempt_id
        WHERE a.person_id IN (SELECT cusp_reach())
$$;

-- Login.

CREATE FUNCTION cusp_inner_open(person bigint) RETURNS text LANGUAGE plpgsql
SET search_path FROM CURRENT AS $$
DECLARE
    token text := cusp_inner_digest(gen_random_uuid()::text || gen_random_uuid()::text);
BEGIN
    DELETE FROM cusp_sessions WHERE until < now();
    INSERT INTO cusp_sessions VALUES (cusp_inner_digest(token), person, now() + interval '7 days');
    PERFORM set_config('cusp.token', token, false);
    RETURN token;
END $$;

CREATE FUNCTION cusp_inner_proven(name text, hash text) RETURNS bigint LANGUAGE sql STABLE
SET search_path FROM CURRENT AS $$
    SELECT id FROM people WHERE username = name AND disabled = 0 AND password_hash <> '' AND password_hash = hash
$$;

CREATE FUNCTION cusp_inner_coded(name text, code_hash text) RETURNS bigint LANGUAGE sql STABLE
SET search_path FROM CURRENT AS $$
    SELECT id FROM people WHERE username = name AND disabled = 0 AND reset_hash <> '' AND reset_hash = code_hash
        AND reset_until_utc >= cusp_inner_now()
$$;

-- What a station needs to compute a proof. For an unknown name, and a person without a password, it is as plausible,
-- always the same, and costs as much as that of some person.
CREATE FUNCTION cusp_salt(name text) RETURNS TABLE (uid text, salt text) LANGUAGE plpgsql STABLE SECURITY DEFINER
SET search_path FROM CURRENT AS $$
DECLARE
    decoy text := COALESCE((SELECT s.value FROM settings s WHERE s.owner = '' AND s.name = 'password.decoy'), '');
    draw bytea := sha256(convert_to(decoy || cusp_salt.name, 'UTF8'));
    own text;
    other text;
BEGIN
    IF current_setting('track_activities')::boolean THEN
        RAISE EXCEPTION 'other stations could read the proof; track_activities has to be off for %', session_user
            USING ERRCODE = 'insufficient_privilege';
    END IF;
    SELECT p.uid, p.password_hash INTO uid, own FROM people p WHERE p.username = cusp_salt.name;
    uid := COALESCE(uid, left(encode(sha256(draw), 'hex'), 32));
    salt := substring(own FROM '^.*\$');
    IF COALESCE(salt, '') = '' THEN
        SELECT p.password_hash INTO other FROM people p WHERE p.password_hash <> '' ORDER BY p.uid LIMIT 1
            OFFSET get_byte(draw, 31)::bigint % (SELECT greatest(count(*), 1) FROM people q WHERE q.password_hash <> '');
        salt := substring(COALESCE(other, decoy) FROM '^\$argon2id\$v=19\$[^$]*\$')
            || rtrim(encode(substr(draw, 1, 16), 'base64'), '=') || '$';
    END IF;
    RETURN NEXT;
END $$;

-- The person with this name and proof. A wrong proof takes a second, also if the caller then rolls back.
CREATE FUNCTION cusp_account(name text, hash text) RETURNS TABLE (id bigint, uid text, username text, given_name text,
    family_name text, role text) LANGUAGE plpgsql SECURITY DEFINER SET search_path FROM CURRENT AS $$
BEGIN
    RETURN QUERY SELECT p.id, p.uid, p.username, p.given_name, p.family_name, p.role FROM people p
        WHERE p.id = cusp_inner_proven(name, hash);
    IF NOT FOUND THEN
        PERFORM pg_sleep(1);
    END IF;
END $$;

-- Logs the person in on this connection and returns the token; null if the proof is wrong.
-- dearer: a hash of the same password that costs more; empty: keep it.
CREATE FUNCTION cusp_login(name text, hash text, dearer text) RETURNS text LANGUAGE plpgsql SECURITY DEFINER
SET search_path FROM CURRENT AS $$
DECLARE
    person bigint := cusp_inner_proven(name, hash);
BEGIN
    IF person IS NULL THEN
        PERFORM pg_sleep(1);
        RETURN NULL;
    END IF;
    UPDATE people SET last_login_utc = cusp_inner_now(),
        password_hash = CASE WHEN cusp_inner_is_hash(dearer) THEN dearer ELSE password_hash END WHERE id = person;
    RETURN cusp_inner_open(person);
END $$;

CREATE FUNCTION cusp_is_code(name text, code_hash text) RETURNS boolean LANGUAGE plpgsql SECURITY DEFINER
SET search_path FROM CURRENT AS $$
BEGIN
    IF cusp_inner_coded(name, code_hash) IS NOT NULL THEN
        RETURN true;
    END IF;
    PERFORM pg_sleep(1);
    RETURN false;
END $$;

-- Uses a one-time code up, sets the password and logs the person in; null if the code is wrong.
CREATE FUNCTION cusp_redeem(name text, code_hash text, new_hash text) RETURNS text LANGUAGE plpgsql SECURITY DEFINER
SET search_path FROM CURRENT AS $$
DECLARE
    person bigint := cusp_inner_coded(name, code_hash);
BEGIN
    IF person IS NULL OR NOT cusp_inner_is_hash(new_hash) THEN
        PERFORM pg_sleep(1);
        RETURN NULL;
    END IF;
    UPDATE people SET password_hash = new_hash, reset_hash = '', reset_until_utc = '' WHERE id = person;
    RETURN cusp_inner_open(person);
END $$;

-- Returns false if the proof is wrong. Ends the person's logins elsewhere.
CREATE FUNCTION cusp_set_password(name text, hash text, new_hash text) RETURNS boolean LANGUAGE plpgsql
SECURITY DEFINER SET search_path FROM CURRENT AS $$
DECLARE
    person bigint := cusp_inner_proven(name, hash);
BEGIN
    IF person IS NULL OR NOT cusp_inner_is_hash(new_hash) THEN
        PERFORM pg_sleep(1);
        RETURN false;
    END IF;
    UPDATE people SET password_hash = new_hash, reset_hash = '', reset_until_utc = '' WHERE id = person;
    DELETE FROM cusp_sessions WHERE person_id = person
        AND token_hash IS DISTINCT FROM cusp_inner_digest(current_setting('cusp.token', true));
    RETURN true;
END $$;

-- Makes this connection act for the person who has the token, and returns who that is. Empty: for nobody.
CREATE FUNCTION cusp_resume(token text) RETURNS TABLE (id bigint, uid text, role text, disabled integer)
LANGUAGE plpgsql SECURITY DEFINER SET search_path FROM CURRENT AS $$
BEGIN
    PERFORM set_config('cusp.token', token, false);
    RETURN QUERY SELECT p.id, p.uid, p.role, p.disabled FROM cusp_sessions s JOIN people p ON p.id = s.person_id
        WHERE s.token_hash = cusp_inner_digest(token) AND s.until > now();
END $$;

CREATE FUNCTION cusp_logout() RETURNS void LANGUAGE sql SECURITY DEFINER SET search_path FROM CURRENT AS $$
    DELETE FROM cusp_sessions WHERE token_hash = cusp_inner_digest(current_setting('cusp.token', true));
    SELECT set_config('cusp.token', '', false)
$$;

-- Replaces a password by a one-time code. Admins.
CREATE FUNCTION cusp_reset(person bigint, code_hash text, until_utc text) RETURNS void LANGUAGE plpgsql
SECURITY DEFINER SET search_path FROM CURRENT AS $$
BEGIN
    IF cusp_role() IS DISTINCT FROM 'admin' THEN
        PERFORM cusp_inner_refuse();
    END IF;
    UPDATE people SET password_hash = '', reset_hash = code_hash, reset_until_utc = until_utc WHERE id = person;
    DELETE FROM cusp_sessions WHERE person_id = person AND person <> cusp_person();
END $$;

CREATE FUNCTION cusp_is_new() RETURNS boolean LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT NOT EXISTS (SELECT 1 FROM people)
$$;

CREATE FUNCTION cusp_has_password(person bigint) RETURNS boolean LANGUAGE sql STABLE SECURITY DEFINER
SET search_path FROM CURRENT AS $$
    SELECT password_hash <> '' FROM people WHERE id = person
        AND (cusp_role() = 'admin' OR id IN (SELECT cusp_reach()))
$$;

CREATE FUNCTION cusp_has_code(person bigint) RETURNS boolean LANGUAGE sql STABLE SECURITY DEFINER
SET search_path FROM CURRENT AS $$
    SELECT reset_hash <> '' FROM people WHERE id = person
        AND (cusp_role() = 'admin' OR id IN (SELECT cusp_reach()))
$$;

-- The audit: its end is what everybody needs, to add to it.

CREATE FUNCTION cusp_audit_last() RETURNS bigint LANGUAGE sql STABLE SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT COALESCE(max(seq), 0) FROM audit
$$;

CREATE FUNCTION cusp_audit_hash(number bigint) RETURNS text LANGUAGE sql STABLE SECURITY DEFINER
SET search_path FROM CURRENT AS $$
    SELECT hash FROM audit WHERE seq = number
$$;

-- Attempts. A station delivers what waits in its outbox, whoever is logged in; so these ask for no proof. A score that
-- the recording does not give does not count.

CREATE FUNCTION cusp_person_of(person_uid text) RETURNS bigint LANGUAGE sql STABLE SECURITY DEFINER
SET search_path FROM CURRENT AS $$
    SELECT id FROM people WHERE uid = person_uid
$$;

CREATE FUNCTION cusp_recount(person bigint, lesson text) RETURNS void LANGUAGE sql SECURITY DEFINER
SET search_path FROM CURRENT AS $$
    DELETE FROM standings s WHERE s.person_id = person AND s.lesson_id = lesson;
    INSERT INTO standings (person_id, lesson_id, attempts, best_tenths, passed, last_utc)
    {standings} AND a.person_id = person AND a.lesson_id = lesson {by_lesson}
$$;

-- Whether another person's attempt, before the one with this id, has the same recording.
CREATE FUNCTION cusp_is_copied(hash text, person bigint, before bigint) RETURNS boolean LANGUAGE sql STABLE
SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT EXISTS (SELECT 1 FROM attempts b WHERE b.recording_hash = hash AND b.recording_hash <> '' AND hash <> ''
        AND b.id < before AND b.person_id <> person)
$$;

-- Whether the lesson is assigned to the person, but never was in this version.
CREATE FUNCTION cusp_is_of_another_version(person bigint, lesson text, version text) RETURNS boolean LANGUAGE sql
STABLE SECURITY DEFINER SET search_path FROM CURRENT AS $$
    SELECT lesson <> '' AND count(*) > 0 AND NOT bool_or(s.lesson_hash = '' OR COALESCE(v.lesson_hash, '') = version)
        FROM assignments s JOIN enrolments e ON e.class_id = s.class_id JOIN people p ON p.id = e.person_id
        LEFT JOIN assigned_versions v ON v.class_id = s.class_id AND v.lesson_id = s.lesson_id
        WHERE e.person_id = person AND p.role = 'student' AND s.lesson_id = lesson
$$;

-- Stores an attempt with its score sheet, and returns its id; null if another person's attempt has this uid.
CREATE FUNCTION cusp_deliver_attempt(given jsonb, sheet text) RETURNS TABLE (id bigint, is_new boolean, doubt text)
LANGUAGE plpgsql SECURITY DEFINER SET search_path FROM CURRENT AS $$
DECLARE
    one attempts := jsonb_populate_record(NULL::attempts, given);
BEGIN
    IF one.person_id IS NULL OR length(one.uid) <> 32 THEN
        PERFORM cusp_inner_refuse();
    END IF;
    one.id := nextval(pg_get_serial_sequence('attempts', 'id'));
    one.given_tenths := NULL;
    one.checked := 0;
    IF one.doubt = '' AND one.recording_hash <> ''
        AND NOT EXISTS (SELECT 1 FROM recordings r WHERE r.hash = one.recording_hash) THEN
        one.doubt := 'recording';
    ELSIF one.doubt = '' AND cusp_is_copied(one.recording_hash, one.person_id, one.id) THEN
        one.doubt := 'recording';
    ELSIF one.doubt = '' AND cusp_is_of_another_version(one.person_id, one.lesson_id, one.lesson_hash) THEN
        one.doubt := 'version';
    END IF;
    INSERT INTO attempts SELECT (one).* ON CONFLICT DO NOTHING;
    is_new := FOUND;
    doubt := one.doubt;
    SELECT a.id INTO id FROM attempts a WHERE a.uid = one.uid AND a.person_id = one.person_id;
    IF is_new THEN
        INSERT INTO score_sheets (attempt_id, json) VALUES (one.id, sheet);
        PERFORM cusp_recount(one.person_id, one.lesson_id);
    END IF;
    RETURN NEXT;
END $$;

-- Returns whether the start of the exam was not stored before.
CREATE FUNCTION cusp_deliver_exam(start_uid text, person bigint, lesson text, begun text) RETURNS boolean
LANGUAGE plpgsql SECURITY DEFINER SET search_path FROM CURRENT AS $$
BEGIN
    INSERT INTO exam_starts (uid, person_id, lesson_id, begun_utc) VALUES (start_uid, person, lesson, begun)
        ON CONFLICT DO NOTHING;
    RETURN FOUND;
END $$;

-- Gives a student of one's own class another score. Instructors.
CREATE FUNCTION cusp_override(attempt bigint, tenths integer, words text, at_utc text) RETURNS void LANGUAGE plpgsql
SECURITY DEFINER SET search_path FROM CURRENT AS $$
DECLARE
    one attempts;
BEGIN
    SELECT a.* INTO one FROM attempts a JOIN people p ON p.id = a.person_id WHERE a.id = attempt AND p.role = 'student'
        AND a.person_id <> cusp_person() AND a.person_id IN (SELECT cusp_reach());
    IF one.id IS NULL OR cusp_role() IS DISTINCT FROM 'instructor' THEN
        PERFORM cusp_inner_refuse();
    END IF;
    INSERT INTO overrides (attempt_id, author_id, given_utc, given_tenths, reason)
        VALUES (attempt, cusp_person(), at_utc, tenths, words);
    UPDATE attempts SET given_tenths = tenths WHERE id = attempt;
    PERFORM cusp_recount(one.person_id, one.lesson_id);
END $$;

-- Comparison with the class: scores without names, and only of classes of {fewest} students or more.

-- someone: other than in the next call, so that nobody can compute whose it is.
CREATE FUNCTION cusp_band(person bigint, lesson text) RETURNS TABLE (someone text, score integer, duration_ms bigint)
LANGUAGE sql SECURITY DEFINER SET search_path FROM CURRENT AS $$
    WITH once AS MATERIALIZED (SELECT gen_random_uuid()::text AS secret)
    SELECT cusp_inner_digest(once.secret || a.person_id), COALESCE(a.given_tenths, a.score_tenths), a.duration_ms
    FROM once, attempts a JOIN people p ON p.id = a.person_id
    WHERE a.lesson_id = lesson AND {counts} AND p.role = 'student' AND p.disabled = 0
        AND (person IN (SELECT cusp_reach()) OR cusp_role() = 'admin')
        AND a.person_id IN (SELECT e.person_id FROM enrolments e WHERE e.class_id IN (
            SELECT mine.class_id FROM enrolments mine JOIN enrolments theirs ON theirs.class_id = mine.class_id
                JOIN people one ON one.id = theirs.person_id
            WHERE mine.person_id = person AND one.role = 'student' AND one.disabled = 0
                AND (cusp_role() <> 'instructor' OR mine.class_id IN (SELECT cusp_classes()))
            GROUP BY mine.class_id HAVING count(*) >= {fewest}))
        AND {device} = COALESCE((SELECT {own_device} FROM attempts own WHERE own.person_id = person
            AND own.lesson_id = lesson ORDER BY own.finished_utc DESC, own.id DESC LIMIT 1), {device})
    ORDER BY 1, a.finished_utc, a.id
$$;

-- The best scores in the person's classes. If there are too few, those of the others are 0.
CREATE FUNCTION cusp_bests(lesson text, rubric text, by_device text) RETURNS SETOF integer LANGUAGE sql STABLE
SECURITY DEFINER SET search_path FROM CURRENT AS $$
    WITH best AS (
        SELECT a.person_id, max(COALESCE(a.given_tenths, a.score_tenths)) AS tenths
        FROM attempts a JOIN people p ON p.id = a.person_id
        WHERE a.lesson_id = lesson AND a.rubric_hash = rubric AND {counts} AND {device} = by_device
            AND (a.person_id = cusp_person() OR (p.role = 'student' AND p.disabled = 0 AND a.person_id IN (
                SELECT e.person_id FROM enrolments e WHERE e.class_id IN (SELECT cusp_classes()))))
        GROUP BY a.person_id)
    SELECT CASE WHEN person_id = cusp_person() OR (SELECT count(*) FROM best) >= {fewest} THEN tenths ELSE 0 END
        FROM best ORDER BY 1
$$;

DO $$
DECLARE
    one record;
BEGIN
    FOR one IN SELECT oid::regprocedure AS name, starts_with(proname::text, 'cusp_inner_') AS is_inner FROM pg_proc
        WHERE pronamespace = current_schema()::regnamespace AND starts_with(proname::text, 'cusp_')
    LOOP
        EXECUTE format('REVOKE ALL ON FUNCTION %s FROM PUBLIC', one.name);
        IF NOT one.is_inner THEN
            EXECUTE format('GRANT EXECUTE ON FUNCTION %s TO {station}', one.name);
        END IF;
    END LOOP;
END $$;

-- Tables and columns.

GRANT SELECT ON classes, enrolments, lesson_versions, assignments, assigned_versions, settings, attempts, score_sheets,
    standings, recordings, comments, overrides, presets, exam_starts, audit, audit_seal, cusp_schema TO {station};

GRANT SELECT (id, uid, username, given_name, family_name, role, disabled, reset_until_utc, created_utc, last_login_utc),
    INSERT (uid, username, given_name, family_name, role, disabled, password_hash, reset_hash, reset_until_utc,
    created_utc, last_login_utc), UPDATE (given_name, family_name, role, disabled) ON people TO {station};

GRANT INSERT (name), UPDATE (name) ON classes TO {station};

GRANT INSERT, DELETE ON enrolments TO {station};

GRANT INSERT ON lesson_versions, assigned_versions, recordings, audit TO {station};

GRANT INSERT (class_id, lesson_id, due_utc, attempt_limit, lesson_hash, created_by, created_utc),
    UPDATE (due_utc, attempt_limit, lesson_hash), DELETE ON assignments TO {station};

GRANT INSERT, UPDATE (value) ON settings TO {station};

GRANT UPDATE (doubt, checked) ON attempts TO {station};

GRANT INSERT (attempt_id, author_id, written_utc, words, x_um, y_um, z_um, moment_ms), UPDATE (withdrawn_utc)
    ON comments TO {station};

GRANT INSERT (name, version, hash, json, author_id, created_utc) ON presets TO {station};

-- Not by column: a lock on the table, by which stations take turns, needs the right to the whole of it.
GRANT UPDATE ON audit_seal TO {station};

-- By hashes of names, and only for waiting times: cusp_account() slows down who guesses with another program.
GRANT SELECT, INSERT, UPDATE, DELETE ON failed_logins TO {station};

-- Rows. Each policy asks for the person once per statement, not once per row.

DO $$
DECLARE
    one text;
BEGIN
    FOREACH one IN ARRAY ARRAY['people', 'classes', 'enrolments', 'lesson_versions', 'assignments', 'assigned_versions',
        'settings', 'attempts', 'score_sheets', 'standings', 'recordings', 'comments', 'overrides', 'presets',
        'exam_starts', 'audit', 'audit_seal', 'failed_logins', 'cusp_schema', 'cusp_sessions', 'cusp_grants']
    LOOP
        EXECUTE format('ALTER TABLE %I ENABLE ROW LEVEL SECURITY', one);
    END LOOP;
END $$;

CREATE POLICY cusp_read ON people FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR id IN (SELECT cusp_shown()));

CREATE POLICY cusp_add ON people FOR INSERT TO {station}
    WITH CHECK ((SELECT cusp_role()) = 'admin' AND password_hash = '');

CREATE POLICY cusp_change ON people FOR UPDATE TO {station} USING ((SELECT cusp_role()) = 'admin');

CREATE POLICY cusp_read ON classes FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR id IN (SELECT cusp_classes()));

CREATE POLICY cusp_add ON classes FOR INSERT TO {station} WITH CHECK ((SELECT cusp_role()) = 'admin');

CREATE POLICY cusp_change ON classes FOR UPDATE TO {station} USING ((SELECT cusp_role()) = 'admin');

CREATE POLICY cusp_read ON enrolments FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR person_id IN (SELECT cusp_reach()));

CREATE POLICY cusp_add ON enrolments FOR INSERT TO {station} WITH CHECK ((SELECT cusp_role()) = 'admin');

CREATE POLICY cusp_remove ON enrolments FOR DELETE TO {station} USING ((SELECT cusp_role()) = 'admin');

-- The limits of a student's other classes count too, and an instructor sees them.
CREATE POLICY cusp_read ON assignments FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR class_id IN (SELECT e.class_id FROM enrolments e));

CREATE POLICY cusp_add ON assignments FOR INSERT TO {station}
    WITH CHECK (created_by = (SELECT cusp_person()) AND ((SELECT cusp_role()) = 'admin'
        OR ((SELECT cusp_role()) = 'instructor' AND class_id IN (SELECT cusp_classes()))));

CREATE POLICY cusp_change ON assignments FOR UPDATE TO {station}
    USING ((SELECT cusp_role()) = 'admin'
        OR ((SELECT cusp_role()) = 'instructor' AND class_id IN (SELECT cusp_classes())));

CREATE POLICY cusp_remove ON assignments FOR DELETE TO {station}
    USING ((SELECT cusp_role()) = 'admin'
        OR ((SELECT cusp_role()) = 'instructor' AND class_id IN (SELECT cusp_classes())));

CREATE POLICY cusp_read ON assigned_versions FOR SELECT TO {station}
    USING ((SELECT cusp_role()) IN ('instructor', 'admin') OR class_id IN (SELECT cusp_classes()));

CREATE POLICY cusp_add ON assigned_versions FOR INSERT TO {station}
    WITH CHECK ((SELECT cusp_role()) = 'admin'
        OR ((SELECT cusp_role()) = 'instructor' AND class_id IN (SELECT cusp_classes())));

CREATE POLICY cusp_read ON lesson_versions FOR SELECT TO {station}
    USING ((SELECT cusp_role()) IN ('instructor', 'admin')
        OR EXISTS (SELECT 1 FROM assigned_versions v WHERE v.lesson_hash = hash));

CREATE POLICY cusp_add ON lesson_versions FOR INSERT TO {station}
    WITH CHECK ((SELECT cusp_role()) IN ('instructor', 'admin'));

CREATE POLICY cusp_read ON settings FOR SELECT TO {station}
    USING ((owner = '' AND (name NOT LIKE 'password.%' OR name IN ('password.passes', 'password.memory')
        OR (SELECT cusp_role()) = 'admin')) OR owner = (SELECT cusp_uid())
        OR (name LIKE 'feedback.%' AND EXISTS (SELECT 1 FROM people p WHERE p.uid = owner)));

CREATE POLICY cusp_add ON settings FOR INSERT TO {station}
    WITH CHECK ((owner = '' AND (SELECT cusp_role()) = 'admin') OR owner = (SELECT cusp_uid()));

CREATE POLICY cusp_change ON settings FOR UPDATE TO {station}
    USING ((owner = '' AND (SELECT cusp_role()) = 'admin') OR owner = (SELECT cusp_uid()));

CREATE POLICY cusp_read ON attempts FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR person_id IN (SELECT cusp_reach()));

CREATE POLICY cusp_check ON attempts FOR UPDATE TO {station}
    USING ((SELECT cusp_role()) = 'admin'
        OR ((SELECT cusp_role()) = 'instructor' AND person_id IN (SELECT cusp_reach())));

CREATE POLICY cusp_read ON score_sheets FOR SELECT TO {station}
    USING (EXISTS (SELECT 1 FROM attempts a WHERE a.id = attempt_id));

CREATE POLICY cusp_read ON recordings FOR SELECT TO {station}
    USING (EXISTS (SELECT 1 FROM attempts a WHERE a.recording_hash = hash AND a.recording_hash <> ''));

CREATE POLICY cusp_deliver ON recordings FOR INSERT TO {station} WITH CHECK (true);

CREATE POLICY cusp_read ON standings FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR person_id IN (SELECT cusp_reach()));

CREATE POLICY cusp_read ON exam_starts FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR person_id IN (SELECT cusp_reach()));

CREATE POLICY cusp_read ON comments FOR SELECT TO {station}
    USING (EXISTS (SELECT 1 FROM attempts a WHERE a.id = attempt_id));

CREATE POLICY cusp_add ON comments FOR INSERT TO {station}
    WITH CHECK ((SELECT cusp_role()) = 'instructor' AND author_id = (SELECT cusp_person())
        AND EXISTS (SELECT 1 FROM attempts a WHERE a.id = attempt_id AND a.person_id <> (SELECT cusp_person())));

CREATE POLICY cusp_withdraw ON comments FOR UPDATE TO {station}
    USING ((SELECT cusp_role()) = 'instructor' AND author_id = (SELECT cusp_person()));

CREATE POLICY cusp_read ON overrides FOR SELECT TO {station}
    USING (EXISTS (SELECT 1 FROM attempts a WHERE a.id = attempt_id));

CREATE POLICY cusp_read ON presets FOR SELECT TO {station} USING (true);

CREATE POLICY cusp_add ON presets FOR INSERT TO {station}
    WITH CHECK ((SELECT cusp_role()) = 'admin' AND author_id = (SELECT cusp_person()));

-- Rows without names that every station compares: who the school is, which stations sign, and restored backups.
CREATE POLICY cusp_read ON audit FOR SELECT TO {station}
    USING ((SELECT cusp_role()) = 'admin' OR seq = 1
        OR action IN ('station.join', 'school.copied', 'backup.restored'));

-- Rows are added at the end only, and nobody adds one in the name of another person, except what a delivery notes.
CREATE POLICY cusp_add ON audit FOR INSERT TO {station}
    WITH CHECK (seq = cusp_audit_last() + 1 AND (actor = (SELECT cusp_uid())
        OR action IN ('attempt.add', 'attempt.doubt', 'exam.begin') OR (actor = '' AND action = 'login.failed')
        OR (actor = 'system' AND action IN ('station.join', 'audit.broken', 'audit.older', 'backup.restored'))));

CREATE POLICY cusp_read ON audit_seal FOR SELECT TO {station} USING (true);

CREATE POLICY cusp_sign ON audit_seal FOR UPDATE TO {station}
    USING (true) WITH CHECK (seq = cusp_audit_last() AND hash = cusp_audit_hash(seq));

CREATE POLICY cusp_wait ON failed_logins TO {station} USING (true);

CREATE POLICY cusp_read ON cusp_schema FOR SELECT TO {station} USING (true);
