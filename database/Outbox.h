// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "database/Address.h"
#include "database/AttemptRecord.h"
#include "database/Login.h"
#include "database/StationKey.h"

namespace database {

/// Graded attempts, and exams that were begun, on their way to the database: each a file that is on the disk before the
/// student is told that his score is kept, and goes when the database has it. A server that is away, a database that is
/// locked or a disk that is full there holds nobody up; a program that is killed in between delivers at its next start,
/// and the attempt's uid sees to it that it arrives once. Any one thread at a time.
class Outbox
{
public:
    /// An attempt that waits.
    struct PendingAttempt
    {
        AttemptRecord attempt;
        QByteArray recording;
        QString school;  ///< for which it was put there, see schoolAt(); empty: an earlier program did not say
    };
    /// An exam's beginning that waits.
    struct ExamLetter
    {
        std::string personUid;
        ExamStart start;
        QString school;
    };

    /// @param folder  is made when the first attempt is put there
    /// @param school  for which attempts are put there, see schoolAt(); empty: for whichever knows the person
    Outbox(QString folder, StationKey key, QString school = {})
        : m_folder(std::move(folder)), m_key(std::move(key)), m_school(std::move(school))
    {}

    /// What a letter calls a school, so that a copy of it gets none of its letters: of a file its name beside the
    /// outbox, which holds after the folder was moved with all in it; of a server host, port and database, whoever
    /// logs in there.
    /// @param folder  of the station's own files, in which the outbox is
    [[nodiscard]] static QString schoolAt(const Address& address, const QString& folder);

    /// Puts an attempt of the session's person there, on the disk when this returns. NotAllowed: a guest's.
    [[nodiscard]] core::Status put(const Login& session, const AttemptRecord& attempt, const QByteArray& recording);

    /// As put(), for an exam that the session's person has begun: ending the program does not make it undone.
    [[nodiscard]] core::Status put(const Login& session, const ExamStart& start);

    /// Those that wait, oldest first; an exam's beginning stands before what came of it.
    [[nodiscard]] QStringList waiting() const;
    [[nodiscard]] static bool isExam(const QString& file);
    /// BadStructure: damaged; such a file is for setAside(). FileMissing: another program has delivered it. NotAllowed:
    /// signed with another key than this station has now; it waits until that one is back.
    [[nodiscard]] core::Result<PendingAttempt> read(const QString& file) const;
    [[nodiscard]] core::Result<ExamLetter> readExam(const QString& file) const;
    /// False: another program has done so before, or it cannot be done.
    bool remove(const QString& file) const;
    /// Moves it into the folder "arrived" beside it: the database has it, but no backup of the database has it yet.
    /// False as in remove().
    bool keepArrived(const QString& file) const;
    /// Those in that folder, without those of another school whose file is there. The next verified backup of the
    /// school removes them.
    [[nodiscard]] QStringList arrived() const;
    /// Moves those in that folder back, so that they are sent again after an older database was restored. The database
    /// takes each attempt once.
    void sendAgain() const;
    /// Into the folder "damaged" beside it: nothing is thrown away.
    void setAside(const QString& file) const;

private:
    [[nodiscard]] bool isOfAnother(const QString& file) const;
    [[nodiscard]] core::Status write(const QString& name, const std::string& content) const;
    [[nodiscard]] core::Result<std::string> contentOf(const QString& file) const;

    QString m_folder;
    StationKey m_key;
    QString m_school;
};

}  // namespace database
