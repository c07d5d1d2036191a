// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Roster.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <QString>

#include "database/Csv.h"
#include "database/Passwords.h"
#include "database/Usernames.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

using Kind = RosterFault::Kind;

const std::string kImporting = "import the class list";
constexpr std::array<const char*, 5> kRosterColumns{"username", "given_name", "family_name", "role", "class"};

/// Names of the columns in spreadsheets in the languages of the window, and common English names.
constexpr std::array kMeant{
    std::pair{"benutzername", "username"},
    std::pair{"anmeldename", "username"},
    std::pair{"login", "username"},
    std::pair{"usuario", "username"},
    std::pair{"nombre de usuario", "username"},
    std::pair{"ユーザー名", "username"},
    std::pair{"ログイン名", "username"},
    std::pair{"vorname", "given_name"},
    std::pair{"first name", "given_name"},
    std::pair{"nombre", "given_name"},
    std::pair{"nombre de pila", "given_name"},
    std::pair{"名", "given_name"},
    std::pair{"nachname", "family_name"},
    std::pair{"familienname", "family_name"},
    std::pair{"last name", "family_name"},
    std::pair{"surname", "family_name"},
    std::pair{"apellido", "family_name"},
    std::pair{"apellidos", "family_name"},
    std::pair{"姓", "family_name"},
    std::pair{"rolle", "role"},
    std::pair{"rol", "role"},
    std::pair{"papel", "role"},
    std::pair{"役割", "role"},
    std::pair{"klasse", "class"},
    std::pair{"klassen", "class"},
    std::pair{"grupo", "class"},
    std::pair{"grupos", "class"},
    std::pair{"clase", "class"},
    std::pair{"クラス", "class"},
};

std::string trimmed(const std::string& text)
{
    return QString::fromStdString(text).simplified().toStdString();
}

struct Line
{
    int number = 0;
    NewPerson who;
    bool saysRole = false;
    bool isShort = false;
    std::vector<std::string> classes;
};

/// The position of each column in the file, by name.
using Places = std::map<std::string, std::size_t>;

/// Returns the edit distance of two words: the number of letters to insert, remove or change.
std::size_t distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = std::exchange(row[j + 1], std::min({changed, row[j] + 1, row[j + 1] + 1}));
        }
    }
    return row.back();
}

/// Returns the column that a name means, otherwise the one with the nearest spelling. Empty if half of the letters or
/// more differ.
std::string nearestColumn(const std::string& name)
{
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    for (const auto& [word, column] : kMeant)
        if (words == word)
            return column;
    const char* const nearest =
        *std::min_element(kRosterColumns.begin(), kRosterColumns.end(),
                          [&](const char* a, const char* b) { return distance(name, a) < distance(name, b); });
    return 2 * distance(name, nearest) < name.size() ? nearest : std::string();
}

/// Returns the positions of the columns. Adds all faults of the first line to `faults`.
Places placesOf(const CsvRow& head, std::vector<RosterFault>& faults)
{
    Places places;
    for (std::size_t at = 0; at < head.fields.size(); ++at) {
        const std::string name = QString::fromStdString(trimmed(head.fields[at])).toLower().toStdString();
        if (name.empty())
            continue;
        if (std::find(kRosterColumns.begin(), kRosterColumns.end(), name) == kRosterColumns.end()) {
            const std::string nearest = nearestColumn(name);
            faults.push_back({head.line, name,
                              "is no column of a class list" +
                                  (nearest.empty() ? nearest : ", perhaps it is \"" + nearest + "\"") +
                                  "; the columns are username, given_name, family_name, role and class",
                              Kind::NoSuchColumn, nearest});
        } else if (!places.emplace(name, at).second)
            faults.push_back({head.line, name, "is there twice", Kind::ColumnTwice, {}});
    }
    if (places.count("username") == 0)
        faults.push_back(
            {head.line, "username", "is missing; the first line names the columns", Kind::ColumnMissing, {}});
    return places;
}

RosterFault faultOf(const CsvFault& fault)
{
    const std::string sign = std::to_string(fault.sign);
    switch (fault.kind) {
    case CsvFault::Kind::OpenQuote:
        return {fault.line, "", "a quote begins at sign " + sign + " and is not closed", Kind::OpenQuote, sign};
    case CsvFault::Kind::AfterQuote:
        return {fault.line, "", "words stand behind a closing quote at sign " + sign + "; double quotes within a field",
                Kind::AfterQuote, sign};
    case CsvFault::Kind::NoUtf8:
    case CsvFault::Kind::TooLarge:
        break;
    }
    return {fault.line, "", "is no UTF-8 text from sign " + sign + " on; save it from the spreadsheet as \"CSV UTF-8\"",
            Kind::NoUtf8, sign};
}

class RosterReader
{
public:
    RosterReader(const Places& places, std::vector<RosterFault>& faults) : m_places(places), m_faults(faults) {}

    std::optional<Line> read(const CsvRow& row)
    {
        const std::size_t before = m_faults.size();
        Line line;
        line.number = row.line;
        line.isShort = row.fields.size() < widest();
        // Spreadsheets write empty columns behind the last one. Text in a column without a name must not get lost.
        bool hasMore = false;
        for (std::size_t k = 0; k < row.fields.size(); ++k)
            hasMore = hasMore || (!isNamed(k) && !trimmed(row.fields[k]).empty());
        if (hasMore)
            fault(row, "", "has more fields than the first line names", Kind::Fields);
        line.who = {at(row, "username"), at(row, "given_name"), at(row, "family_name"), Role::Student};
        if (const auto name = normalUsername(line.who.username); !name)
            fault(row, "username", name.error().detail, Kind::Username);
        else if (!m_seen.emplace(*name, row.line).second)
            fault(row, "username", "stands in line " + std::to_string(m_seen[*name]) + " already", Kind::Twice,
                  std::to_string(m_seen[*name]));
        else
            line.who.username = *name;
        for (const auto& [column, name] :
             {std::pair("given_name", &line.who.givenName), std::pair("family_name", &line.who.familyName)})
            if (const auto fit = checkPersonName(*name); !fit)
                fault(row, column, fit.error().detail, Kind::Name);
        if (const std::string role = QString::fromStdString(at(row, "role")).toLower().toStdString(); !role.empty()) {
            const auto known = roleOf(role);
            line.saysRole = true;
            if (known && *known != Role::Guest)
                line.who.role = *known;
            else
                fault(row, "role", "is none of student, instructor, admin", Kind::Role);
        }
        for (const QString& name : QString::fromStdString(at(row, "class")).split('|', Qt::SkipEmptyParts))
            if (const auto fit = checkClassName(name.toStdString()); fit)
                line.classes.push_back(*fit);
            else
                fault(row, "class", fit.error().detail, Kind::Class);
        return m_faults.size() == before ? std::optional(line) : std::nullopt;
    }

private:
    [[nodiscard]] std::size_t widest() const
    {
        std::size_t most = 0;
        for (const auto& [name, place] : m_places)
            most = std::max(most, place + 1);
        return most;
    }
    [[nodiscard]] bool isNamed(std::size_t place) const
    {
        return std::any_of(m_places.begin(), m_places.end(), [place](const auto& one) { return one.second == place; });
    }
    [[nodiscard]] std::string at(const CsvRow& row, const char* column) const
    {
        const auto place = m_places.find(column);
        return place != m_places.end() && place->second < row.fields.size() ? trimmed(row.fields[place->second])
                                                                            : std::string();
    }
    void fault(const CsvRow& row, const std::string& column, const std::string& what, Kind kind,
               const std::string& value = {})
    {
        m_faults.push_back({row.line, column, what, kind, value});
    }

    const Places& m_places;
    std::vector<RosterFault>& m_faults;
    std::map<std::string, int> m_seen;
};

/// The people and classes before the import.
struct Present
{
    std::map<std::string, Person> people;    ///< by username
    std::map<std::string, ClassId> classes;  ///< by name
};

core::Result<Present> presentAt(const DatabaseContext& school)
{
    Present present;
    if (auto read =
            forEach(school.db, "SELECT id, uid, username, given_name, family_name, role FROM people", kImporting, {},
                    [&](const QSqlQuery& row) {
                        Person person;
                        person.id = {row.value(0).toLongLong()};
                        person.uid = textOf(row, 1);
                        person.username = textOf(row, 2);
                        person.givenName = textOf(row, 3);
                        person.familyName = textOf(row, 4);
                        person.role = roleOf(textOf(row, 5)).value_or(Role::Student);
                        present.people.emplace(person.username, person);
                    });
        !read)
        return tl::unexpected(read.error());
    if (auto read = forEach(
            school.db, "SELECT name, id FROM classes", kImporting, {},
            [&](const QSqlQuery& row) { present.classes.emplace(textOf(row, 0), ClassId{row.value(1).toLongLong()}); });
        !read)
        return tl::unexpected(read.error());
    return present;
}

/// Computes the outcome of a list without applying it. Sets `outcome`, and returns the lines to import.
std::vector<Line> plan(const std::vector<Line>& lines, const Present& present, RosterOutcome& outcome)
{
    std::vector<Line> wanted;
    std::set<std::string> newClasses;
    for (const Line& line : lines) {
        Line whole = line;
        const auto before = present.people.find(line.who.username);
        const bool isThere = before != present.people.end();
        if (isThere) {
            const Person& person = before->second;
            if (person.isErased()) {
                outcome.faults.push_back({line.number,
                                          "username",
                                          "belongs to a person who was erased and cannot come back; choose another",
                                          Kind::Erased,
                                          {}});
                continue;
            }
            if (line.saysRole && person.role != line.who.role) {
                outcome.faults.push_back({line.number, "role",
                                          "is \"" + std::string(roleName(person.role)) +
                                              "\" here; a class list does not change what somebody is",
                                          Kind::OtherRole, std::string(roleName(person.role))});
                continue;
            }
            // Fields that are empty in the list keep their value.
            whole.who.role = person.role;
            if (whole.who.givenName.empty())
                whole.who.givenName = person.givenName;
            if (whole.who.familyName.empty())
                whole.who.familyName = person.familyName;
        }
        for (const std::string& name : whole.classes)
            if (present.classes.count(name) == 0 && newClasses.insert(name).second)
                outcome.newClasses.push_back(name);
        const std::string fullName = trimmed(whole.who.givenName + ' ' + whole.who.familyName);
        const std::string known = isThere ? before->second.fullName() : fullName;
        outcome.people.push_back({whole.who.username,
                                  fullName,
                                  whole.who.role,
                                  whole.classes,
                                  !isThere,
                                  {},
                                  known == fullName ? std::string() : known,
                                  line.isShort});
        wanted.push_back(std::move(whole));
    }
    return wanted;
}

core::Status rename(const DatabaseContext& school, AuditBatch& audit, const Login& session, const Person& before,
                    const NewPerson& who)
{
    if (before.givenName == who.givenName && before.familyName == who.familyName)
        return {};
    Person renamed = before;
    renamed.givenName = who.givenName;
    renamed.familyName = who.familyName;
    if (auto done = execute(school.db, "UPDATE people SET given_name = ?, family_name = ? WHERE id = ?", kImporting,
                            {text(who.givenName), text(who.familyName), number(before.id.value)});
        !done)
        return done;
    return audit.note(session.uid(), "person.change", "person:" + before.uid,
                      {{"names_digest", QString::fromStdString(digestOfNames(renamed))}});
}

/// Imports one line, and returns the code of a new person.
core::Result<std::string> take(const DatabaseContext& school, AuditBatch& audit, const Login& session, const Line& line,
                               Present& present)
{
    std::string code;
    PersonId id;
    if (const auto before = present.people.find(line.who.username); before != present.people.end()) {
        id = before->second.id;
        if (auto renamed = rename(school, audit, session, before->second, line.who); !renamed)
            return tl::unexpected(renamed.error());
    } else {
        code = newCode();
        const auto entered = enter(school, audit, session.uid(), line.who, {{}, code});
        if (!entered)
            return tl::unexpected(entered.error());
        id = entered->id;
    }
    for (const std::string& name : line.classes) {
        auto there = present.classes.find(name);
        if (there == present.classes.end()) {
            const auto made = classNamed(school, audit, session.uid(), name);
            if (!made)
                return tl::unexpected(made.error());
            there = present.classes.emplace(name, *made).first;
        }
        if (auto put = putInto(school, audit, session.uid(), there->second, id); !put)
            return tl::unexpected(put.error());
    }
    return code;
}

/// Imports all lines inside a transaction and records them in the audit. Imports none if there are faults.
core::Status enterAll(const DatabaseContext& school, const Login& session, const std::vector<Line>& lines,
                      RosterOutcome& outcome, const RosterOutcome* asSeen, const KeepCodes& keepCodes)
{
    auto present = presentAt(school);
    if (!present)
        return tl::unexpected(present.error());
    const std::vector<Line> wanted = plan(lines, *present, outcome);
    if (!outcome.faults.empty())
        return {};
    if (asSeen != nullptr && (outcome.people != asSeen->people || outcome.newClasses != asSeen->newClasses))
        return core::unexpected(ErrorCode::ChangedSince, "somebody else has entered or changed people since the class "
                                                         "list was looked at");
    AuditBatch audit(school);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        auto code = take(school, audit, session, wanted[k], *present);
        if (!code && code.error().code == ErrorCode::OutOfRange)
            outcome.faults.push_back({wanted[k].number, "", code.error().detail, Kind::Refused, {}});
        if (!code)
            return tl::unexpected(code.error());
        outcome.people[k].code = std::move(*code);
    }
    if (auto sealed = audit.seal(); !sealed)
        return sealed;
    return keepCodes ? keepCodes(outcome.people) : core::Status();
}

}  // namespace

core::Result<RosterOutcome> importRoster(const DatabaseContext& school, const Login& session, std::string_view csv,
                                         bool dryRun, const RosterOutcome* asSeen, const KeepCodes& keepCodes)
{
    for (const Operation operation : {Operation::AddPerson, Operation::ChangePerson, Operation::ChangeClasses})
        if (auto who = authorize(school, session, operation); !who)
            return tl::unexpected(who.error());
    const auto rows = readCsv(csv);
    if (!rows && rows.error().kind == CsvFault::Kind::TooLarge)
        return core::unexpected(ErrorCode::FileTooLarge, "the file is larger than 16 MiB; split it");
    RosterOutcome outcome;
    if (!rows) {
        outcome.faults.push_back(faultOf(rows.error()));
        return outcome;
    }
    if (rows->empty())
        return core::unexpected(ErrorCode::FileEmpty, "the file is empty; its first line names the columns username, "
                                                      "given_name, family_name, role and class");
    if (rows->size() > kMostRosterLines)
        return core::unexpected(
            ErrorCode::FileTooLarge,
            QStringLiteral("the file has more than %1 lines; split it").arg(kMostRosterLines).toStdString());
    const Places places = placesOf(rows->front(), outcome.faults);
    if (!outcome.faults.empty())
        return outcome;
    RosterReader reader(places, outcome.faults);
    std::vector<Line> lines;
    for (auto row = rows->begin() + 1; row != rows->end(); ++row)
        if (auto line = reader.read(*row))
            lines.push_back(std::move(*line));
    // A dry run only reads, so it does not make others wait.
    if (dryRun || !outcome.faults.empty()) {
        const auto present = presentAt(school);
        if (!present)
            return tl::unexpected(present.error());
        static_cast<void>(plan(lines, *present, outcome));
    } else if (auto done = inTurn(school, kImporting,
                                  [&] { return enterAll(school, session, lines, outcome, asSeen, keepCodes); });
               !done && outcome.faults.empty()) {
        return tl::unexpected(done.error());
    }
    if (!outcome.faults.empty()) {
        outcome.people.clear();
        outcome.newClasses.clear();
    }
    std::sort(outcome.faults.begin(), outcome.faults.end(),
              [](const RosterFault& a, const RosterFault& b) { return a.line < b.line; });
    return outcome;
}

}  // namespace database::sql
