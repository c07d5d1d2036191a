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

/// Stores graded attempts and started exams until they are in the database, each in a file. The file is on the disk
/// before the student sees that the score is saved. It is removed after the database has stored its contents. So no
/// user has to wait for an unavailable server, a locked database or a full disk on the server. If the program is
/// killed, it delivers the files at its next start. The attempt's uid ensures that an attempt is stored only once. Use
/// it in one thread at a time.
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

    /// @param folder  created when the first attempt is stored
    /// @param school  identity of the school for new attempts, see schoolAt(); empty: any school that contains the
    ///                person
    Outbox(QString folder, StationKey key, QString school = {})
        : m_folder(std::move(folder)), m_key(std::move(key)), m_school(std::move(school))
    {}

    /// Returns the identity of a school that is written to the files, so that a copy of the school receives none of
    /// them. For a file it is the path relative to `folder`, which stays valid when that folder is moved with all its
    /// contents. For a server it consists of host, port and database, without the user.
    /// @param folder  of the station's own files, which contains the outbox
    [[nodiscard]] static QString schoolAt(const Address& address, const QString& folder);

    /// Stores an attempt of the logged-in person; it is on the disk when this returns. NotAllowed for a guest.
    [[nodiscard]] core::Status put(const Login& session, const AttemptRecord& attempt, const QByteArray& recording);

    /// Stores the start of an exam of the logged-in person; it is on the disk when this returns. Ending the program
    /// does not undo it. NotAllowed for a guest.
    [[nodiscard]] core::Status put(const Login& session, const ExamStart& start);

    /// Returns the waiting files, oldest first; the start of an exam comes before its result.
    [[nodiscard]] QStringList waiting() const;
    [[nodiscard]] static bool isExam(const QString& file);
    /// Reads a file. BadStructure: it is damaged; call setAside(). FileMissing: another program has delivered it.
    /// NotAllowed: it was signed with the key of another station; it stays in the outbox until that key is back.
    [[nodiscard]] core::Result<PendingAttempt> read(const QString& file) const;
    [[nodiscard]] core::Result<ExamLetter> readExam(const QString& file) const;
    /// Removes a file. Returns false if another program has removed it, or on failure.
    bool remove(const QString& file) const;
    /// Moves a file into the folder "arrived" beside it: the database has it, but no backup has yet. Returns false as
    /// in remove().
    bool keepArrived(const QString& file) const;
    /// Returns the files in the folder "arrived", except those of another school whose database exists. They are
    /// removed after the next verified backup of the school.
    [[nodiscard]] QStringList arrived() const;
    /// Moves the files in the folder "arrived" back to the outbox. They are then delivered again, after an older
    /// database was restored. The database stores each attempt once.
    void sendAgain() const;
    /// Moves a file into the folder "damaged" beside it, so that no file is lost.
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
