// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Audit.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <set>
#include <utility>

#include <QJsonDocument>
#include <QRegularExpression>
#include <QSqlError>

#include "core/base/Bytes.h"
#include "database/Passwords.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kNote = "note it in the audit";
constexpr std::size_t kCodeDigits = 12;
/// A row is not believed whose number is over this, or so much over that of the signed one: the program's own never get
/// there, and one that was slipped in does not lead them to where numbers end.
constexpr std::int64_t kHighest = std::numeric_limits<std::int64_t>::max() / 4;
constexpr std::int64_t kFarthest = 1'000'000'000;
constexpr std::size_t kLongestRun = 1000;  ///< of rows that were slipped in or taken out together
/// Of rows that tell of a break no school has more. Each is compared with every row before it; of many that somebody
/// has made up each only with the longest run, so that they hold nobody up who looks.
constexpr std::size_t kUsualBreaks = 8;
const QString kColumns = QStringLiteral("seq, at_utc, actor, action, object, detail, hash");
const QString kNoAttempt = QStringLiteral("AND action NOT IN ('attempt.add', 'exam.begin')");

AuditRow rowOf(const QSqlQuery& query)
{
    return {query.value(0).toLongLong(),
            textOf(query, 1),
            textOf(query, 2),
            textOf(query, 3),
            textOf(query, 4),
            textOf(query, 5),
            textOf(query, 6)};
}

/// Noted where the chain was found to end otherwise than was signed.
const std::string kBroken = "audit.broken";
/// Noted before the first row that a station signs, with its key. Chains from before that was noted do not begin so.
const std::string kJoin = "station.join";

std::string stationOf(const std::string& key)
{
    return "station:" + key;
}

std::string wordsOf(const AuditHead& head)
{
    return "cusp audit " + std::to_string(head.seq) + ' ' + head.hash;
}

/// Of an audit code: its row, and the beginning of that one's hash.
QRegularExpressionMatch matchCode(const std::string& typed)
{
    static const QRegularExpression kCode(QStringLiteral("^([1-9][0-9]{0,17})-([0-9a-f]{12,64})$"));
    return kCode.match(QString::fromStdString(typed).trimmed().toLower());
}

/// Reads the chain row by row and says where it does not hold.
class ChainReader
{
public:
    /// @param signedSeq  of the row that was signed as the newest
    /// @param lastSeq    of the last row there is
    /// @param broken     rows that tell that the chain ended otherwise than was signed, the newest first
    ChainReader(const std::vector<std::string>& witnesses, std::int64_t signedSeq, std::int64_t lastSeq,
                std::vector<AuditRow> broken)
        : m_signedSeq(std::min(signedSeq, kHighest)), m_lastSeq(lastSeq), m_broken(std::move(broken))
    {
        for (const std::string& witness : witnesses) {
            const auto found = matchCode(witness);
            if (!found.hasMatch())
                say(QT_TRANSLATE_NOOP("Finding",
                                      "\"%1\" is no audit code; a report shows one such as 412-9f3ac07be1d2"),
                    {witness});
            else
                m_witnesses.push_back({found.captured(1).toLongLong(), found.captured(2).toStdString()});
        }
        lookAhead(0, {});
    }

    void take(const AuditRow& row)
    {
        ++m_rows;
        witness(row);
        const bool isBelieved = row.seq > 0 && row.seq <= kHighest;
        if (!isBelieved || row.seq < m_goesOnAt) {
            takeUnsigned(row);
            if (isBelieved) {  // it may be the program's own, and the head have been set back, to it or to one before
                               // it
                lookAhead(row.seq, row.hash);
                if (row.action == kJoin)
                    m_stations.insert(row.object);
            }
            return;
        }
        const std::string before = row.seq == m_goesOnAt ? m_goesOnFrom : m_last.hash;
        const bool isNext = row.seq == m_last.seq + 1 || row.seq == m_goesOnAt;
        const bool isRenumbered = !isNext && isAs(row, m_last.seq + 1 + m_shift, before);
        if (isRenumbered)
            tellRenumbered(row);
        if (!isSigned(row.seq)) {
            takeUnsigned(row);
            // What goes on from the signed row is looked at like all else: it may be the signed number that was
            // changed.
            if (!m_goesOnUnsigned)
                m_goesOnUnsigned = (isNext || isRenumbered) && isAs(row, row.seq + m_shift, before);
            if (!*m_goesOnUnsigned)
                return;
        } else if (!isNext && !isRenumbered) {  // what stood before this row is not known
            takeGap({m_last.seq + 1 + m_shift, row.seq - 1 - m_last.seq, m_last.hash, {}});
        }
        if (row.action == kJoin)
            m_stations.insert(row.object);
        if (row.seq == 1)
            m_areStationsNoted = row.action == kJoin;
        if (row.action == kBroken)
            sayLacking(
                QT_TRANSLATE_NOOP(
                    "Finding",
                    "audit row %1 (%2, %3, %4) tells that the rows before it did not end as they had been signed"),
                named(row));
        // One that tells of a break may, behind the signed row, go on from any before that.
        if (isNext && !isAs(row, row.seq + m_shift, before) && !explain(row) &&
            (isSigned(row.seq) || row.action != kBroken))
            suspect(row, before);
        m_beforeLast = before;
        m_recent.push_back({row, before});
        if (m_recent.size() > kLongestRun + 1)
            m_recent.pop_front();
        m_last = row;
        if (!m_continueWith.empty())
            m_last.hash = std::exchange(m_continueWith, {});
        if (row.seq + m_shift == m_signedSeq)
            m_signed = m_last;
        lookAhead(row.seq, m_last.hash);
    }

    [[nodiscard]] ChainReport conclude(const QSqlQuery& seal)
    {
        const AuditHead head{seal.value(0).toLongLong(), textOf(seal, 1)};
        const std::string key = textOf(seal, 3);
        const bool isSealed = head.seq == 0 || StationKey::isSigned(wordsOf(head), textOf(seal, 2), key);
        const std::int64_t newest = m_last.seq + m_shift;
        if (head.seq > newest)
            takeGap({newest + 1, head.seq - newest, m_last.hash, {}});
        settle();
        if (head.seq <= newest && isSealed && m_signed && head.hash != m_signed->hash)
            sayLacking(QT_TRANSLATE_NOOP("Finding",
                                         "audit row %1 (%2, %3, %4) is not the one that was signed: it was changed, "
                                         "or the signature was put there from elsewhere"),
                       named(*m_signed));
        for (const auto& [first, last] : m_unsigned)
            tellUnsigned(first, last);
        if (!isSealed)
            say(QT_TRANSLATE_NOOP(
                "Finding",
                "the signature of the newest row of the audit was not made by the station whose key stands beside it"));
        if (head.seq > 0 && m_areStationsNoted && m_stations.count(stationOf(key)) == 0)
            say(QT_TRANSLATE_NOOP("Finding", "the newest row of the audit was signed with the key %1, and the audit "
                                             "knows no station that has it"),
                {key.substr(0, kCodeDigits)});
        for (const Witness& witness : m_witnesses)
            if (!witness.isSeen && witness.seq > m_last.seq)
                sayLacking(QT_TRANSLATE_NOOP(
                               "Finding",
                               "audit row %1, which a report names, is not there: it was removed, or the code is "
                               "not typed as it stands there"),
                           {std::to_string(witness.seq)});
        return {std::move(m_findings), m_rows, m_lacksRows};
    }

private:
    struct Witness
    {
        std::int64_t seq = 0;
        std::string hash;
        bool isSeen = false;
    };

    /// Where rows are missing.
    struct Gap
    {
        std::int64_t first = 0;  ///< number of the first, as it was written
        std::int64_t count = 0;
        std::string hashBefore;          ///< of the row that stands before them
        std::optional<AuditRow> behind;  ///< the next one, where the numbers were made to go on
    };
    /// Rows that stand together, and elsewhere than they were written.
    struct Moved
    {
        AuditRow first;
        std::int64_t last = 0;       ///< number
        std::int64_t writtenAs = 0;  ///< the first
    };

    static std::vector<std::string> named(const AuditRow& row)
    {
        return {std::to_string(row.seq), row.atUtc, row.action, row.object};
    }
    static std::vector<std::string> with(std::vector<std::string> values, const std::vector<std::string>& others)
    {
        values.insert(values.end(), others.begin(), others.end());
        return values;
    }
    void say(const char* words, const std::vector<std::string>& values = {})
    {
        if (m_findings.size() < kMostFindings)
            m_findings.push_back({words, values});
    }
    /// Of what may have taken a note with it.
    void sayLacking(const char* words, const std::vector<std::string>& values = {})
    {
        m_lacksRows = true;
        say(words, values);
    }
    /// Of a number as it is now.
    [[nodiscard]] bool isSigned(std::int64_t seq) const { return seq + m_shift <= m_signedSeq; }
    /// Adds to what no signature covers.
    void takeUnsigned(const AuditRow& row)
    {
        // One that was taken from before the signed row belongs there.
        if (const auto gap = std::find_if(m_gaps.begin(), m_gaps.end(),
                                          [&row](const Gap& one) { return isAs(row, one.first, one.hashBefore); });
            gap != m_gaps.end()) {
            fill(*gap, {row});
            return;
        }
        if (!m_unsigned.empty() && m_unsigned.back().second >= row.seq - 1)
            m_unsigned.back().second = row.seq;
        else if (m_unsigned.size() < kMostFindings)
            m_unsigned.emplace_back(row.seq, row.seq);
    }
    /// Looks whether a row behind goes on from this one, as the program writes where rows stand behind the signed one:
    /// those between them, however many, are not of the chain. Of several it is the last: what was signed then follows
    /// from that.
    void lookAhead(std::int64_t seq, const std::string& hash)
    {
        while (!m_broken.empty() && m_broken.back().seq <= seq)
            m_broken.pop_back();
        const auto goesOn = std::find_if(m_broken.begin(), m_broken.end(), [&](const AuditRow& row) {
            if (m_areManyBroken && row.seq - seq > static_cast<std::int64_t>(kLongestRun) + 1)
                return false;
            // One that nobody has signed says nothing of those that were.
            return (isSigned(row.seq) || !isSigned(seq + 1)) && isAs(row, row.seq + m_shift, hash);
        });
        if (goesOn == m_broken.end() || goesOn->seq <= m_goesOnAt)
            return;
        m_goesOnAt = goesOn->seq;
        m_goesOnFrom = hash;
    }
    void takeGap(const Gap& gap)
    {
        if (m_gaps.size() < kMostFindings)
            m_gaps.push_back(gap);
        else
            m_lacksRows = true;
    }
    /// Rows that were taken out and rows that were slipped in elsewhere are the same ones where the chain goes on with
    /// them from what stands before the gap: then they were moved. Returns whether they are.
    bool fill(Gap& gap, const std::vector<AuditRow>& rows)
    {
        if (static_cast<std::int64_t>(rows.size()) > gap.count)
            return false;
        std::string before = gap.hashBefore;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (!isAs(rows[k], gap.first + static_cast<std::int64_t>(k), before))
                return false;
            before = rows[k].hash;
        }
        for (const AuditRow& row : rows)
            takeMoved(row, gap.first++);
        gap.count -= static_cast<std::int64_t>(rows.size());
        gap.hashBefore = before;
        return true;
    }
    void takeMoved(const AuditRow& row, std::int64_t writtenAs)
    {
        if (!m_moved.empty() && m_moved.back().last + 1 == row.seq &&
            m_moved.back().writtenAs - m_moved.back().first.seq == writtenAs - row.seq)
            m_moved.back().last = row.seq;
        else if (m_moved.size() < kMostFindings)
            m_moved.push_back({row, row.seq, writtenAs});
    }
    /// It follows from the one before it, but for its number: nothing that stood between them was taken out.
    void tellRenumbered(const AuditRow& row)
    {
        say(QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) and those behind it were renumbered"), named(row));
        m_shift -= row.seq - m_last.seq - 1;
    }
    /// Which of these it is the chain does not say: whoever has the file in his hands can chain rows as the program
    /// does.
    void tellUnsigned(std::int64_t first, std::int64_t last)
    {
        if (first == last)
            say(QT_TRANSLATE_NOOP("Finding",
                                  "no signature covers audit row %1: it was inserted, or the signed head was "
                                  "set back, or the row behind it was changed"),
                {std::to_string(first)});
        else
            say(QT_TRANSLATE_NOOP("Finding",
                                  "no signature covers audit rows %1 to %2: they were inserted, or the signed "
                                  "head was set back, or the row behind them was changed"),
                {std::to_string(first), std::to_string(last)});
    }
    [[nodiscard]] static bool isAs(const AuditRow& row, std::int64_t seq, const std::string& hashBefore)
    {
        if (row.seq == seq)
            return hashOf(row, hashBefore) == row.hash;
        AuditRow as = row;
        as.seq = seq;
        return hashOf(as, hashBefore) == row.hash;
    }
    /// Rows from this one on are explained.
    void forgive(std::int64_t first)
    {
        m_suspects.erase(
            std::remove_if(m_suspects.begin(), m_suspects.end(), [&](const Suspect& s) { return s.row.seq >= first; }),
            m_suspects.end());
    }
    /// Of a row that does not follow from the one before: whether it tells what was done to that one.
    bool explain(const AuditRow& row)
    {
        const std::int64_t seq = row.seq + m_shift;
        if (isAs(row, seq - 1, m_beforeLast)) {
            m_suspects.erase(std::remove_if(m_suspects.begin(), m_suspects.end(),
                                            [&](const Suspect& s) { return s.row.seq == m_last.seq; }),
                             m_suspects.end());
            if (isAs(m_last, seq, row.hash)) {
                say(QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) and row %5 (%6, %7, %8) were exchanged"),
                    with(named(m_last), named(row)));
                m_continueWith = m_last.hash;
            } else {
                takeInserted({m_last});
            }
            return true;
        }
        return m_suspects.size() < kMostFindings && (explainInserted(row) || explainRemoved(row));
    }
    /// Whether several rows before the last one were slipped in, and it and those behind it renumbered. One row alone
    /// that fits in somewhere before may also have been moved: the next one has to fit behind it.
    bool explainInserted(const AuditRow& row)
    {
        if (const auto run = std::exchange(m_run, {}); run && isAs(row, row.seq + m_shift - run->count, m_last.hash)) {
            forgive(run->first);
            std::vector<AuditRow> rows;
            for (const Recent& recent : m_recent)
                if (recent.row.seq >= run->first && static_cast<std::int64_t>(rows.size()) < run->count)
                    rows.push_back(recent.row);
            takeInserted(std::move(rows));
            return true;
        }
        for (std::size_t count = 2; count <= std::min(m_recent.size(), kLongestRun) && !m_run; ++count)
            if (const Recent& first = m_recent[m_recent.size() - count];
                isAs(row, row.seq + m_shift - static_cast<std::int64_t>(count), first.before))
                m_run = Run{first.row.seq, static_cast<std::int64_t>(count)};
        return false;
    }
    /// Whether rows were taken out before the last one, and it and those behind it renumbered. That one itself follows
    /// from what is not there any more.
    bool explainRemoved(const AuditRow& row)
    {
        const auto fits = [&](std::int64_t count) { return isAs(row, row.seq + m_shift + count, m_last.hash); };
        std::int64_t count = 1;
        while (count <= static_cast<std::int64_t>(kLongestRun) && !fits(count))
            ++count;
        if (count > static_cast<std::int64_t>(kLongestRun)) {
            // However many it were, if nothing else was done: what the last number lacks.
            count = m_signedSeq - m_lastSeq - m_shift;
            if (count < 1 || !fits(count))
                return false;
        }
        if (!m_suspects.empty() && m_suspects.back().row.seq == m_last.seq)
            m_suspects.pop_back();
        takeGap({m_last.seq + m_shift, count, m_beforeLast, m_last});
        m_shift += count;
        return true;
    }
    /// Of rows that stand together up to the last one.
    void takeInserted(std::vector<AuditRow> rows)
    {
        m_shift -= static_cast<std::int64_t>(rows.size());
        if (m_inserted.size() < kMostFindings)
            m_inserted.push_back(std::move(rows));
    }
    void tellMissing(const Gap& gap)
    {
        const std::string first = std::to_string(gap.first);
        if (gap.behind && gap.count == 1)
            sayLacking(
                QT_TRANSLATE_NOOP(
                    "Finding", "before audit row %1 (%2, %3, %4) a row was removed, and those behind were renumbered"),
                named(*gap.behind));
        else if (gap.behind)
            sayLacking(QT_TRANSLATE_NOOP(
                           "Finding",
                           "before audit row %1 (%2, %3, %4) %5 rows were removed, and those behind were renumbered"),
                       with(named(*gap.behind), {std::to_string(gap.count)}));
        else if (gap.count == 1)
            sayLacking(QT_TRANSLATE_NOOP("Finding", "audit row %1 was removed"), {first});
        else
            sayLacking(QT_TRANSLATE_NOOP("Finding", "audit rows %1 to %2 were removed"),
                       {first, std::to_string(gap.first + gap.count - 1)});
    }
    void tellInserted(const std::vector<AuditRow>& rows)
    {
        if (rows.size() == 1)
            say(QT_TRANSLATE_NOOP("Finding",
                                  "audit row %1 (%2, %3, %4) was inserted, and those behind it were renumbered"),
                named(rows.front()));
        else
            say(QT_TRANSLATE_NOOP("Finding",
                                  "audit rows %1 to %2 were inserted, and those behind them were renumbered"),
                {std::to_string(rows.front().seq), std::to_string(rows.back().seq)});
    }
    void tellMoved(const Moved& moved)
    {
        const std::int64_t behind = moved.last - moved.first.seq;
        if (behind == 0)
            say(QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) was moved: it was written as row %5"),
                with(named(moved.first), {std::to_string(moved.writtenAs)}));
        else
            say(QT_TRANSLATE_NOOP("Finding", "audit rows %1 to %2 were moved: they were written as rows %3 to %4"),
                {std::to_string(moved.first.seq), std::to_string(moved.last), std::to_string(moved.writtenAs),
                 std::to_string(moved.writtenAs + behind)});
    }
    /// What was taken out and what was slipped in, as far as that is not the same.
    void settleNumbers()
    {
        const auto fillOne = [this] {
            for (Gap& gap : m_gaps)
                for (auto rows = m_inserted.begin(); rows != m_inserted.end(); ++rows)
                    if (fill(gap, *rows)) {
                        m_inserted.erase(rows);
                        return true;
                    }
            return false;
        };
        while (fillOne()) {
        }
        for (const Moved& moved : m_moved)
            tellMoved(moved);
        for (const Gap& gap : m_gaps)
            if (gap.count > 0)
                tellMissing(gap);
        for (const auto& rows : m_inserted)
            tellInserted(rows);
    }
    void suspect(const AuditRow& row, const std::string& before)
    {
        if (m_suspects.size() < kMostFindings)
            m_suspects.push_back({row, before});
    }
    /// Those that fit into each other's place were moved there. One that follows from a row that was moved is sound.
    void settle()
    {
        settleNumbers();
        for (const Suspect& suspect : m_suspects) {
            const auto fits = [&](const Suspect& place) {
                return place.row.seq != suspect.row.seq && isAs(suspect.row, place.row.seq, place.before);
            };
            const auto leads = [&](const Suspect& other) { return isAs(suspect.row, suspect.row.seq, other.row.hash); };
            const auto place = std::find_if(m_suspects.begin(), m_suspects.end(), fits);
            if (place != m_suspects.end())
                say(QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) was moved: it was written as row %5"),
                    with(named(suspect.row), {std::to_string(place->row.seq)}));
            else if (std::none_of(m_suspects.begin(), m_suspects.end(), leads))
                sayLacking(QT_TRANSLATE_NOOP(
                               "Finding",
                               "audit row %1 (%2, %3, %4) was changed, or the one before it was and its hash with it"),
                           named(suspect.row));
        }
    }
    void witness(const AuditRow& row)
    {
        for (Witness& witness : m_witnesses) {
            if (witness.seq != row.seq)
                continue;
            witness.isSeen = true;
            if (row.hash.rfind(witness.hash, 0) != 0)
                say(QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) is not the one that a report names: it or "
                                                 "one before it was changed, or the code is not typed as it "
                                                 "stands there"),
                    named(row));
        }
    }

    struct Recent
    {
        AuditRow row;
        std::string before;  ///< hash of the row that stands before it
    };
    /// Of rows that may have been slipped in.
    struct Run
    {
        std::int64_t first = 0;
        std::int64_t count = 0;
    };
    struct Suspect
    {
        AuditRow row;
        std::string before;  ///< hash of the row that stands before it
    };

    std::int64_t m_signedSeq;
    std::int64_t m_lastSeq;
    std::vector<AuditRow> m_broken;  ///< those still to come, the newest first
    const bool m_areManyBroken = m_broken.size() > kUsualBreaks;
    std::int64_t m_goesOnAt = 0;  ///< where the chain goes on; what stands before that is passed over
    std::string m_goesOnFrom;     ///< hash of the row that it follows from
    std::vector<std::pair<std::int64_t, std::int64_t>> m_unsigned;  ///< first and last of rows that stand together
    std::optional<bool> m_goesOnUnsigned;                           ///< the first behind the signed one follows from it
    std::optional<AuditRow> m_signed;                               ///< what stands where the signed one should
    std::vector<Witness> m_witnesses;
    std::vector<Finding> m_findings;
    AuditRow m_last;
    std::string m_beforeLast;  ///< hash of the row before m_last
    std::deque<Recent> m_recent;
    std::optional<Run> m_run;
    std::string m_continueWith;  ///< what the next row follows from, where that is not the last one read
    std::int64_t m_shift = 0;    ///< what a row's number was when it was written, less what it is
    std::vector<Suspect> m_suspects;
    std::vector<Gap> m_gaps;
    std::vector<std::vector<AuditRow>> m_inserted;  ///< each those that stand together, where numbers go on behind them
    std::vector<Moved> m_moved;
    std::int64_t m_rows = 0;  ///< so far
    bool m_lacksRows = false;
    std::set<std::string> m_stations;  ///< that have joined
    bool m_areStationsNoted = false;
};

}  // namespace

std::string hashOf(const AuditRow& row, const std::string& hashBefore)
{
    core::ByteWriter bytes;
    bytes.putText(hashBefore);
    bytes.put(row.seq);
    for (const std::string* part : {&row.atUtc, &row.actor, &row.action, &row.object, &row.detail})
        bytes.putText(*part);
    return digestOf(bytes.bytes());
}

bool isAuditCode(const std::string& typed)
{
    return matchCode(typed).hasMatch();
}

std::string AuditHead::code() const
{
    return seq == 0 ? std::string("0") : std::to_string(seq) + '-' + hash.substr(0, kCodeDigits);
}

core::Status AuditBatch::begin()
{
    bool isThere = false;
    bool isSigned = false;
    bool isSound = false;
    std::int64_t last = 0;
    bool mustJoin = false;
    bool isFirst = false;
    const QString joined = QStringLiteral("EXISTS (SELECT 1 FROM audit j WHERE j.action = '%1' AND j.object = %2)")
                               .arg(QString::fromStdString(kJoin));
    if (auto read = forEach(
            m_school.db,
            "SELECT s.seq, s.hash, s.signature, s.station_key, COALESCE(a.hash, ''), (SELECT COALESCE(MAX(seq), 0) "
            "FROM audit WHERE seq <= CASE WHEN s.seq BETWEEN 0 AND ? THEN s.seq ELSE 0 END + ?), COALESCE((SELECT "
            "b.action FROM audit b WHERE b.seq = 1), ''), CASE WHEN " +
                joined.arg("'station:' || s.station_key") + " THEN 1 ELSE 0 END, CASE WHEN " + joined.arg("?") +
                " THEN 1 ELSE 0 END FROM audit_seal s LEFT JOIN audit a ON a.seq = s.seq WHERE s.id = 1" +
                QString(dialect::isPostgres(m_school.db) ? " FOR UPDATE OF s" : ""),
            kNote,
            {static_cast<qlonglong>(kHighest), static_cast<qlonglong>(kFarthest),
             text(stationOf(m_school.key.publicHex()))},
            [&](const QSqlQuery& row) {
                m_seq = row.value(0).toLongLong();
                m_hash = textOf(row, 1);
                isThere = true;
                isFirst = m_seq == 0;
                const bool areStationsNoted = isFirst || textOf(row, 6) == kJoin;
                isSigned = isFirst || (StationKey::isSigned(wordsOf({m_seq, m_hash}), textOf(row, 2), textOf(row, 3)) &&
                                       (!areStationsNoted || row.value(7).toInt() == 1));
                last = row.value(5).toLongLong();
                isSound = isSigned && m_seq == last && m_hash == textOf(row, 4);
                mustJoin = areStationsNoted && row.value(8).toInt() == 0;
            });
        !read)
        return read;
    if (!isThere)
        return core::unexpected(core::ErrorCode::BadStructure, "database " + dialect::nameOf(m_school.db) +
                                                                   ": the head of its audit is missing; restore a "
                                                                   "backup of it");
    // Numbers have to be left for what is noted from now on: one that nobody has signed must not come near their end.
    if (m_seq > (isSigned ? kHighest : kHighest / 2)) {
        const auto found = ask(m_school.db, "SELECT COALESCE(MAX(seq), 0) FROM audit WHERE seq <= ?", kNote,
                               {static_cast<qlonglong>(kFarthest)});
        if (!found)
            return tl::unexpected(found.error());
        m_seq = found->toLongLong();
    } else {
        m_seq = std::max(m_seq, last);
    }
    m_insert.emplace(m_school.db);
    if (!m_insert->prepare(QStringLiteral("INSERT INTO audit (%1) VALUES (?, ?, ?, ?, ?, ?, ?)").arg(kColumns)))
        return tl::unexpected(dialect::error(m_school.db, m_insert->lastError(), kNote));
    // To sign on as if nothing had happened would make good what somebody has done to the chain.
    if (auto noted = isSound ? core::Status() : note("system", kBroken, "audit"); !noted || !mustJoin)
        return noted;
    // The first row of all tells schools apart, whoever begins two of them at once.
    const QJsonObject school{{"school", QString::fromStdString(newUid())}};
    return note("system", kJoin, stationOf(m_school.key.publicHex()), isFirst ? school : QJsonObject());
}

core::Status AuditBatch::note(const std::string& actor, const std::string& action, const std::string& object,
                              const QJsonObject& detail)
{
    if (!m_insert)
        if (auto begun = begin(); !begun)
            return begun;
    AuditRow row;
    row.seq = m_seq + 1;
    row.atUtc = m_school.now();
    row.actor = actor;
    row.action = action;
    row.object = object;
    row.detail = QJsonDocument(detail).toJson(QJsonDocument::Compact).toStdString();
    row.hash = hashOf(row, m_hash);
    int place = 0;
    m_insert->bindValue(place++, static_cast<qlonglong>(row.seq));
    for (const std::string* part : {&row.atUtc, &row.actor, &row.action, &row.object, &row.detail, &row.hash})
        m_insert->bindValue(place++, text(*part));
    if (!m_insert->exec())
        return tl::unexpected(dialect::error(m_school.db, m_insert->lastError(), kNote));
    m_seq = row.seq;
    m_hash = row.hash;
    return {};
}

core::Status AuditBatch::seal()
{
    if (!m_insert)
        return {};
    m_insert.reset();
    return execute(m_school.db, "UPDATE audit_seal SET seq = ?, hash = ?, signature = ?, station_key = ? WHERE id = 1",
                   kNote,
                   {static_cast<qlonglong>(m_seq), text(m_hash), text(m_school.key.sign(wordsOf({m_seq, m_hash}))),
                    text(m_school.key.publicHex())});
}

core::Status takeTurn(const School& school)
{
    if (auto right = checkClock(school.nowUtc()); !right)
        return right;
    const QString turn = dialect::lockTurn(school.db);
    return turn.isEmpty() ? core::Status() : execute(school.db, turn, kNote);
}

core::Status note(const School& school, const std::string& actor, const std::string& action, const std::string& object,
                  const QJsonObject& detail)
{
    AuditBatch batch(school);
    if (auto noted = batch.note(actor, action, object, detail); !noted)
        return noted;
    return batch.seal();
}

core::Result<AuditHead> auditHead(const QSqlDatabase& db)
{
    AuditHead head;
    if (auto read = forEach(db, "SELECT seq, hash FROM audit_seal WHERE id = 1", "read the audit", {},
                            [&](const QSqlQuery& row) {
                                head = {row.value(0).toLongLong(), textOf(row, 1)};
                            });
        !read)
        return tl::unexpected(read.error());
    return head;
}

core::Result<std::vector<AuditRow>> readAudit(const School& school, const Session& session, int limit,
                                              std::int64_t beforeSeq, AuditRows which)
{
    if (auto who = admit(school, session, Operation::ReadAudit); !who)
        return tl::unexpected(who.error());
    std::vector<AuditRow> rows;
    const QString others = which == AuditRows::All ? QString() : kNoAttempt;
    const qlonglong before = beforeSeq > 0 ? beforeSeq : std::numeric_limits<qlonglong>::max();
    if (auto read = forEach(
            school.db,
            QStringLiteral("SELECT %1 FROM audit WHERE seq < ? %2 ORDER BY seq DESC LIMIT ?").arg(kColumns, others),
            "read the audit", {before, std::max(0, limit)}, [&](const QSqlQuery& row) { rows.push_back(rowOf(row)); });
        !read)
        return tl::unexpected(read.error());
    return rows;
}

core::Result<ChainReport> readChain(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
                                    const std::function<bool(std::int64_t rows)>& progress)
{
    std::vector<AuditRow> broken;
    if (auto read = forEach(db,
                            QStringLiteral("SELECT %1 FROM audit WHERE object = 'audit' AND action = '%2' AND seq <= ? "
                                           "ORDER BY seq DESC LIMIT ?")
                                .arg(kColumns, QString::fromStdString(kBroken)),
                            "read the audit", {static_cast<qlonglong>(kHighest), static_cast<qlonglong>(kMostFindings)},
                            [&](const QSqlQuery& query) { broken.push_back(rowOf(query)); });
        !read)
        return tl::unexpected(read.error());
    std::int64_t signedSeq = std::numeric_limits<std::int64_t>::max();
    std::int64_t lastSeq = 0;
    if (auto read = forEach(db,
                            "SELECT (SELECT seq FROM audit_seal WHERE id = 1), (SELECT MAX(seq) FROM audit WHERE seq "
                            "<= ?)",
                            "read the audit", {static_cast<qlonglong>(kHighest)},
                            [&](const QSqlQuery& row) {
                                if (!row.isNull(0))
                                    signedSeq = row.value(0).toLongLong();
                                lastSeq = row.value(1).toLongLong();
                            });
        !read)
        return tl::unexpected(read.error());
    ChainReader reader(witnesses, signedSeq, lastSeq, std::move(broken));
    bool goesOn = true;
    std::int64_t rows = 0;
    if (auto read = forEach(db, QStringLiteral("SELECT %1 FROM audit ORDER BY seq").arg(kColumns), "read the audit", {},
                            [&](const QSqlQuery& query) {
                                if (!goesOn)
                                    return;
                                reader.take(rowOf(query));
                                ++rows;
                                if (progress)
                                    goesOn = progress(rows);
                            });
        !read)
        return tl::unexpected(read.error());
    if (!goesOn)
        return ChainReport{{}, rows, false};
    auto seal = run(db, "SELECT seq, hash, signature, station_key FROM audit_seal WHERE id = 1", "read the audit");
    if (!seal)
        return tl::unexpected(seal.error());
    if (!seal->next())
        return ChainReport{
            {{QT_TRANSLATE_NOOP("Finding", "the signed head of the audit was removed"), {}}}, rows, false};
    return reader.conclude(*seal);
}

core::Result<std::vector<Finding>> checkAudit(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
                                              const std::function<bool(std::int64_t rows)>& progress)
{
    return readChain(db, witnesses, progress).map([](ChainReport report) { return std::move(report.findings); });
}

}  // namespace database::sql
