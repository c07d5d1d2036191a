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

/// Stores graded attempts, and started exams, on their way to the database, each in a file. The file is on the disk
/// before the student sees that the score is saved, and is removed once the database has it. So an unavailable server,
/// a locked database or a full disk there delays nobody. A program that is killed delivers at its next start, and the
/// attempt's uid ensures that it is stored once. One thread at a time.
class Outbox
{
public:
    /// An attempt to be delivered.
    struct PendingAttempt
    {
        AttemptRecord attempt;
        QByteArray recording;
        QString school;  ///< its school, see schoolAt(); empty: unknown, from an older program
    };
    /// The start of an exam, to be delivered.
    struct ExamLetter
    {
        std::string personUid;
        ExamStart start;
        QString school;
    };

    /// @param folder  created when the first attempt is put there
    /// @param school  of new attempts, see schoolAt(); empty: any school that knows the person
    Outbox(QString folder, StationKey key, QString school = {})
        : m_folder(std::move(folder)), m_key(std::move(key)), m_school(std::move(school))
    {}

    /// Returns the identification of a school in the files, so that a copy of the school gets none of them. For a file
    /// its path relative to the outbox, which stays valid when the folder is moved with all its contents; for a server
    /// host, port and database, whoever logs in.
    /// @param folder  of the station's own files, which contains the outbox
    [[nodiscard]] static QString schoolAt(const Address& address, const QString& folder);

    /// Stores an attempt of the logged-in person; it is on the disk when this returns. NotAllowed for a guest.
    [[nodiscard]] core::Status put(const Login& session, const AttemptRecord& attempt, const QByteArray& recording);

    /// Stores the start of an exam of the logged-in person, likewise: ending the program does not undo it.
    [[nodiscard]] core::Status put(const Login& session, const ExamStart& start);

    /// Returns the waiting files, oldest first; the start of an exam comes before its result.
    [[nodiscard]] QStringList waiting() const;
    [[nodiscard]] static bool isExam(const QString& file);
    /// Reads a file. BadStructure: damaged; call setAside(). FileMissing: another program has delivered it. NotAllowed:
    /// signed with another key than this station's; it waits until that key is back.
    [[nodiscard]] core::Result<PendingAttempt> read(const QString& file) const;
    [[nodiscard]] core::Result<ExamLetter> readExam(const QString& file) const;
    /// Removes a file. Returns false if another program has removed it, or on failure.
    bool remove(const QString& file) const;
    /// Moves a file into the folder "arrived" beside it: the database has it, but no backup has yet. Returns false as
    /// in remove().
    bool keepArrived(const QString& file) const;
    /// Returns the files in that folder, without those of another school whose database exists. The next verified
    /// backup of the school removes them.
    [[nodiscard]] QStringList arrived() const;
    /// Moves the files in that folder back, so that they are sent again after an older database was restored. The
    /// database stores each attempt once.
    void sendAgain() const;
    /// Moves a file into the folder "damaged" beside it: no file is lost.
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
