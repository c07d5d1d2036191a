// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/SchemaCheck.h"

#include <map>
#include <utility>

#include <QScopeGuard>

#include "database/Passwords.h"
#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kDoingSchemaCheck = "check it";
const QString kFresh = QStringLiteral("cusp-fresh-schema-%1");

struct Made
{
    std::string table;  ///< that it is, or stands on
    std::string by;     ///< the statement, or all that defines it
};
/// By "trigger audit_no_update".
using Schema = std::map<std::string, Made>;

/// What this program finds when it names a table, with all that defines it and where it lies, and what hangs on it from
/// elsewhere: a foreign key that names a table of ours, a table whose rows are read among those of ours, a table among
/// whose rows ours are read. A trigger that is switched off, or fires only for copies of another server, is as good as
/// none. Indexes of constraints go with those; the triggers that look after a foreign key do, too; what only says that
/// it is one of those is shown.
QString questionToServer()
{
    return QStringLiteral(R"(
WITH ours AS (SELECT c.oid, c.relname, c.relkind, c.relpersistence, c.relrowsecurity, quote_ident(n.nspname) AS home
              FROM pg_catalog.pg_class c JOIN pg_catalog.pg_namespace n ON n.oid = c.relnamespace
              WHERE n.nspname = ANY (current_schemas(false)) AND pg_table_is_visible(c.oid)
              AND c.relkind IN ('r', 'v', 'm', 'f', 'p'))
SELECT 'table', relname::text, relname::text, concat(relkind, relpersistence, relrowsecurity), home FROM ours
UNION ALL
SELECT 'column', o.relname || '.' || a.attname, o.relname, concat(format_type(a.atttypid, a.atttypmod), a.attnotnull,
       a.attidentity, a.attgenerated, pg_get_expr(d.adbin, d.adrelid), ' ', a.attcollation), o.home
FROM ours o JOIN pg_catalog.pg_attribute a ON a.attrelid = o.oid AND a.attnum > 0 AND NOT a.attisdropped
LEFT JOIN pg_catalog.pg_attrdef d ON d.adrelid = o.oid AND d.adnum = a.attnum WHERE o.relkind = 'r'
UNION ALL
SELECT 'constraint', o.relname || '.' || k.conname, o.relname, concat(pg_get_constraintdef(k.oid),
       (SELECT count(*) FROM pg_catalog.pg_trigger t WHERE t.tgconstraint = k.oid AND t.tgenabled IN ('O', 'A'))), o.home
FROM ours o JOIN pg_catalog.pg_constraint k ON k.conrelid = o.oid WHERE k.contype IN ('c', 'f', 'p', 'u', 'x')
UNION ALL
SELECT 'index', c.relname, o.relname, concat(pg_get_indexdef(c.oid), i.indisvalid, i.indisready), o.home
FROM ours o JOIN pg_catalog.pg_index i ON i.indrelid = o.oid JOIN pg_catalog.pg_class c ON c.oid = i.indexrelid
WHERE NOT EXISTS (SELECT 1 FROM pg_catalog.pg_constraint k WHERE k.conindid = c.oid AND k.contype IN ('p', 'u', 'x'))
UNION ALL
SELECT 'trigger', t.tgname, o.relname, concat(pg_get_triggerdef(t.oid), pg_get_functiondef(t.tgfoid)), o.home
FROM ours o JOIN pg_catalog.pg_trigger t ON t.tgrelid = o.oid JOIN pg_catalog.pg_proc f ON f.oid = t.tgfoid
WHERE t.tgenabled IN ('O', 'A')
AND NOT (t.tgisinternal AND f.pronamespace = 'pg_catalog'::regnamespace AND f.proname LIKE 'RI\_FKey\_%')
UNION ALL
SELECT 'rule', o.relname || '.' || r.rulename, o.relname, pg_get_ruledef(r.oid), o.home
FROM ours o JOIN pg_catalog.pg_rewrite r ON r.ev_class = o.oid WHERE o.relkind = 'r'
UNION ALL
SELECT 'reference', concat(k.conrelid::regclass, '.', k.conname), o.relname, '', o.home
FROM ours o JOIN pg_catalog.pg_constraint k ON k.confrelid = o.oid WHERE k.contype = 'f'
UNION ALL
SELECT 'heir', i.inhrelid::regclass::text, o.relname, '', o.home
FROM ours o JOIN pg_catalog.pg_inherits i ON i.inhparent = o.oid WHERE o.relkind = 'r'
UNION ALL
SELECT 'parent', concat(i.inhparent::regclass, ' of ', o.relname), o.relname, '', o.home
FROM ours o JOIN pg_catalog.pg_inherits i ON i.inhrelid = o.oid WHERE o.relkind = 'r')");
}

/// Of a file, what a constraint brings along has no statement, and two kinds of tables are SQLite's own. Nothing else
/// is left out by its name: a trigger that somebody has called so works like any other.
QString questionToFile()
{
    return QStringLiteral(R"(
SELECT type, name, tbl_name, sql FROM sqlite_master
WHERE sql IS NOT NULL AND NOT (type = 'table' AND (name = 'sqlite_sequence' OR name LIKE 'sqlite\_stat%' ESCAPE '\'))
UNION ALL
SELECT 'reference', m.name || '.' || f."from" || '(' || lower(f."table") || ')', lower(f."table"), ''
FROM sqlite_master m JOIN pragma_foreign_key_list(m.name) f WHERE m.type = 'table')");
}

/// Without the white space that parts no words: ALTER TABLE writes a table anew, each release of SQLite in its own way.
/// What stands in quotes stays as it is, with them: in double ones, too, it may be a text, which guards nothing.
QString withoutSpace(const QString& made)
{
    const auto isOfWord = [](QChar letter) { return letter.isLetterOrNumber() || letter == u'_'; };
    QString kept;
    QChar quote;
    bool wasSpace = false;
    for (const QChar letter : made) {
        if (quote.isNull() && letter.isSpace()) {
            wasSpace = true;
            continue;
        }
        if (std::exchange(wasSpace, false) && isOfWord(letter) && !kept.isEmpty() && isOfWord(kept.back()))
            kept += u' ';
        kept += letter;
        if (letter == quote)
            quote = QChar();
        else if (quote.isNull() && (letter == u'\'' || letter == u'"'))
            quote = letter;
    }
    return kept;
}

core::Result<Schema> schemaOf(const QSqlDatabase& db)
{
    const bool onServer = dialect::isPostgres(db);
    const QString question = onServer ? questionToServer() : questionToFile();
    Schema schema;
    if (auto read = forEach(db, question, kDoingSchemaCheck, {},
                            [&](const QSqlQuery& row) {
                                QString made = row.value(3).toString();
                                // A server says where each thing lies.
                                if (onServer)
                                    made.remove(row.value(4).toString() + '.');
                                // On a server triggers of two tables may have one name.
                                Made& there = schema[textOf(row, 0) + ' ' + textOf(row, 1)];
                                there.table = textOf(row, 2);
                                there.by += withoutSpace(made).toStdString();
                            });
        !read)
        return tl::unexpected(read.error());
    return schema;
}

/// Of a file that the migrations have just made.
core::Result<Schema> freshSchema()
{
    const QString name = kFresh.arg(quintptr(&name));
    const auto remove = qScopeGuard([&name] { QSqlDatabase::removeDatabase(name); });
    QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
    db.setDatabaseName(QStringLiteral(":memory:"));
    if (!db.open())
        return tl::unexpected(dialect::error(db, db.lastError(), kDoingSchemaCheck));
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    if (auto made = migrate(db, *steps); !made)
        return tl::unexpected(made.error());
    return schemaOf(db);
}

/// As the migrations make it on this server: in a schema that nobody sees, and that goes with its transaction.
core::Result<Schema> freshSchemaOnServer(const QSqlDatabase& db)
{
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    if (auto begun = execute(db, "BEGIN", kDoingSchemaCheck); !begun)
        return tl::unexpected(begun.error());
    const auto ended = qScopeGuard([&db] { static_cast<void>(execute(db, "ROLLBACK", kDoingSchemaCheck)); });
    const QString name = "cusp_check_" + QString::fromStdString(newUid());
    for (const char* sql : {"CREATE SCHEMA %1", "SET LOCAL search_path = %1"})
        if (auto done = execute(db, QString::fromLatin1(sql).arg(name), kDoingSchemaCheck); !done)
            return tl::unexpected(done.error());
    if (auto made = applyAll(db, *steps); !made)
        return tl::unexpected(made.error());
    return schemaOf(db);
}

/// A foreign key, at the table that it names.
bool isReference(const std::string& named)
{
    return named.rfind("reference ", 0) == 0;
}

/// Two triggers of a file are one on a server, see dialect::expand().
Schema asOnServer(const Schema& schema)
{
    Schema there;
    for (const auto& [named, made] : schema) {
        const auto guard = named.rfind("_no_update");
        if (guard != std::string::npos)
            there[named.substr(0, guard) + "_no_change"] = {made.table, {}};
        else if (named.rfind("_no_delete") == std::string::npos && !isReference(named))
            there[named] = {made.table, {}};
    }
    return there;
}

/// A server's administrator may let all triggers rest: they stand there, and guard nothing.
core::Status checkGuardsAct(const QSqlDatabase& db, const std::function<void(const Finding&)>& say)
{
    const auto role = ask(db, "SELECT current_setting('session_replication_role')", kDoingSchemaCheck);
    if (!role)
        return tl::unexpected(role.error());
    if (role->toString() != u"origin")
        say({QT_TRANSLATE_NOOP("Finding", "the server lets the triggers of this database rest "
                                          "(session_replication_role is %1): what they guard is not guarded; let its "
                                          "administrator set it to origin"),
             {role->toString().toStdString()}});
    return {};
}

/// What stands beside the tables of a server and is called as something of its own is taken in the place of that where
/// it fits better. To be looked for where nothing but the server's own is found. What an extension brings is its
/// administrator's.
core::Status checkNames(const QSqlDatabase& db, const std::function<void(const Finding&)>& say)
{
    const auto home = ask(db, "SELECT pg_catalog.current_schema()", kDoingSchemaCheck);
    if (!home)
        return tl::unexpected(home.error());
    if (auto begun = execute(db, "BEGIN", kDoingSchemaCheck); !begun)
        return begun;
    const auto ended = qScopeGuard([&db] { static_cast<void>(execute(db, "ROLLBACK", kDoingSchemaCheck)); });
    if (auto alone = execute(db, "SET LOCAL search_path = pg_catalog, pg_temp", kDoingSchemaCheck); !alone)
        return alone;
    return forEach(db, QStringLiteral(R"(
WITH beside AS (SELECT 'function ' || p.oid::regprocedure::text AS named, 'pg_proc'::regclass AS kind, p.oid
                FROM pg_proc p WHERE p.pronamespace = (SELECT oid FROM pg_namespace WHERE nspname = ?)
                AND p.proname IN (SELECT proname FROM pg_proc WHERE pronamespace = 'pg_catalog'::regnamespace)
                UNION ALL
                SELECT 'operator ' || o.oid::regoperator::text, 'pg_operator'::regclass, o.oid
                FROM pg_operator o WHERE o.oprnamespace = (SELECT oid FROM pg_namespace WHERE nspname = ?))
SELECT named FROM beside b
WHERE NOT EXISTS (SELECT 1 FROM pg_depend d WHERE d.classid = b.kind AND d.objid = b.oid AND d.deptype = 'e'))"),
                   kDoingSchemaCheck, {*home, *home}, [&say](const QSqlQuery& row) {
                       say({QT_TRANSLATE_NOOP("Finding", "%1 is not from this program: it may change what is read"),
                            {textOf(row, 0)}});
                   });
}

core::Result<Schema> expectedSchema(const QSqlDatabase& db)
{
    return dialect::isPostgres(db) ? freshSchemaOnServer(db) : freshSchema();
}

/// What was added: a trigger or a rule may do anything, wherever it stands; a constraint, a column or an index may
/// refuse what is written into a table of ours, and a foreign key of a table of others what is removed there. Else
/// tables of others, with what stands on those, do no harm.
void tellAdded(const std::string& named, const Made& made, const Schema& expected,
               const std::function<void(const Finding&)>& say)
{
    const std::string kind = named.substr(0, named.find(' '));
    const bool isOurs = expected.count("table " + made.table) > 0;
    if ((kind == "trigger" || kind == "rule") && isOurs)
        say({QT_TRANSLATE_NOOP("Finding", "%1 is not from this program: it may change what is written"), {named}});
    else if (!isOurs)  // what others keep beside it is theirs
        return;
    else if (kind == "parent")
        say({QT_TRANSLATE_NOOP("Finding",
                               "%1 is not from this program: who changes its rows changes those of the table "
                               "%2, past what guards them"),
             {named, made.table}});
    else if (kind == "heir")
        say({QT_TRANSLATE_NOOP("Finding", "%1 is not from this program: its rows are read among those of the table %2"),
             {named, made.table}});
    else if (kind != "table" && kind != "view")
        say({QT_TRANSLATE_NOOP("Finding", "%1 is not from this program: it may refuse what is to be written"),
             {named}});
}

}  // namespace

core::Status checkSchema(const QSqlDatabase& db, const std::function<void(const Finding&)>& say,
                         const std::function<void(const Finding&)>& note)
{
    if (dialect::isPostgres(db))
        for (const auto look : {&checkGuardsAct, &checkNames})
            if (auto looked = look(db, say); !looked)
                return looked;
    auto expected = expectedSchema(db);
    const bool areNamesAll =
        dialect::isPostgres(db) && !expected && expected.error().code == core::ErrorCode::ServerRefuses;
    if (areNamesAll) {
        note({QT_TRANSLATE_NOOP("Finding",
                                "of tables, indexes and triggers the names alone could be compared: this user "
                                "of the server may not create a schema there; let the owner of the "
                                "database check it"),
              {}});
        expected = freshSchema().map(asOnServer);
    }
    const auto found = schemaOf(db);
    if (!expected || !found)
        return tl::unexpected(expected ? found.error() : expected.error());
    const auto isCompared = [&](const std::string& named) {
        // A file's constraints and columns stand in what made its tables; its foreign keys have no names.
        return !areNamesAll ||
               (named.rfind("constraint ", 0) != 0 && named.rfind("column ", 0) != 0 && !isReference(named));
    };
    for (const auto& [named, made] : *expected)
        if (isReference(named))  // its constraint is compared
            continue;
        else if (const auto there = found->find(named); there == found->end())
            say({QT_TRANSLATE_NOOP("Finding", "%1 is no longer there: what it guarded is not guarded any more"),
                 {named}});
        else if (there->second.table != made.table || (there->second.by != made.by && !areNamesAll))
            say({QT_TRANSLATE_NOOP("Finding", "%1 is not as this program makes it"), {named}});
    for (const auto& [named, made] : *found)
        if (expected->count(named) == 0 && isCompared(named))
            tellAdded(named, made, *expected, say);
    return {};
}

}  // namespace database::sql
