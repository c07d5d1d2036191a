// SPDX-License-Identifier: GPL-3.0-or-later
// A file dialog shows the folder of the database file, and SQLite's locks on the file stay.
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileSystemModel>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <tuple>

#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "ui/kit/FileDialog.h"

namespace {

struct flock wholeFile(short type)
{
    struct flock lock
    {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    return lock;
}

/// Returns whether another process finds a lock on the file; a process does not see its own locks.
bool isLockedForOthers(const QString& path)
{
    const QByteArray name = QFile::encodeName(path);
    const pid_t other = fork();
    if (other == 0) {
        const int file = open(name.constData(), O_RDWR);
        struct flock lock = wholeFile(F_WRLCK);
        fcntl(file, F_GETLK, &lock);
        _exit(lock.l_type == F_UNLCK ? 0 : 1);
    }
    int status = 0;
    waitpid(other, &status, 0);
    return WEXITSTATUS(status) == 1;
}

}  // namespace

class TestFileDialog : public QObject
{
    Q_OBJECT
private slots:
    void looksAtNamesOnly()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("school.sqlite");
        support::write(path, "SQLite format 3");
        QVERIFY(QDir(folder.path()).mkdir("other"));
        const int file = open(QFile::encodeName(path).constData(), O_RDWR);
        struct flock lock = wholeFile(F_RDLCK);
        QCOMPARE(fcntl(file, F_SETLK, &lock), 0);
        QVERIFY(isLockedForOthers(path));
        ui::kit::FileDialog dialog(nullptr, "Choose", folder.path());
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.setViewMode(QFileDialog::Detail);  // shows the type of each file
        dialog.show();
        auto* model = dialog.findChild<QFileSystemModel*>();
        QVERIFY(model != nullptr);
        QTRY_COMPARE(model->rowCount(model->index(folder.path())), 2);
        QTRY_VERIFY(!model->index(path).siblingAtColumn(2).data().toString().isEmpty());
        // When the dialog shows the type of a file that was created later, it has examined all files.
        const QString later = folder.filePath("later.sqlite");
        support::write(later, "SQLite format 3");
        QTRY_COMPARE(model->rowCount(model->index(folder.path())), 3);
        QTRY_VERIFY(!model->index(later).siblingAtColumn(2).data().toString().isEmpty());
        QVERIFY(isLockedForOthers(path));
        close(file);
        QVERIFY(!isLockedForOthers(path));
    }

    void beginsWhereTheLastFileWasSaved()
    {
        const QTemporaryDir settings, documents, stick;
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
        const auto ask = [&] {
            auto dialog = std::make_unique<ui::kit::FileDialog>(nullptr, "Save", documents.path(), "Tables (*.csv)");
            dialog->setAttribute(Qt::WA_DeleteOnClose, false);
            dialog->askWhere("Time: Decay/36", "csv");
            return dialog;
        };
        const auto first = ask();
        QCOMPARE(first->selectedFiles(), QStringList{documents.filePath("Time Decay 36.csv")});
        first->selectFile(stick.filePath("mine.csv"));
        static_cast<QDialog*>(first.get())->accept();
        const auto second = ask();
        QCOMPARE(second->selectedFiles(), QStringList{stick.filePath("Time Decay 36.csv")});
        second->reject();
        QVERIFY(QDir(stick.path()).removeRecursively());  // the drive was unplugged meanwhile
        QCOMPARE(ask()->selectedFiles(), QStringList{documents.filePath("Time Decay 36.csv")});
    }

    /// A link to a file of another type is refused as well. A new file, or one of the saved type, is accepted.
    void replacesNothingOfAnotherKind()
    {
        const QTemporaryDir settings, folder;
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
        for (const char* name : {"school.sqlite", "old.csv"})
            support::write(folder.filePath(name), "");
        QVERIFY(QFile::link(folder.filePath("school.sqlite"), folder.filePath("link.csv")));
        const auto isTaken = [&](const QString& name) {
            ui::kit::FileDialog dialog(nullptr, "Save", folder.path(), "Tables (*.csv)");
            dialog.setAttribute(Qt::WA_DeleteOnClose, false);
            dialog.setOption(QFileDialog::DontConfirmOverwrite);
            QStringList chosen;
            connect(&dialog, &QFileDialog::fileSelected, this, [&chosen](const QString& path) { chosen << path; });
            dialog.askWhere("table", "csv");
            dialog.selectFile(folder.filePath(name));
            static_cast<QDialog*>(&dialog)->accept();
            const auto* refusal = dialog.findChild<QLabel*>("refusal");
            if (chosen.isEmpty() &&
                (!dialog.isVisible() || !refusal->isVisible() || !refusal->text().contains("sqlite")))
                QTest::qFail("it does not say why", __FILE__, __LINE__);
            return !chosen.isEmpty();
        };
        QVERIFY(!isTaken("school.sqlite") && !isTaken("link.csv"));
        QVERIFY(isTaken("old.csv") && isTaken("new.csv"));
    }

    void tellsDatesAndSizesInTheProgramsLanguage()
    {
        QTemporaryDir folder;
        QFile made(folder.filePath("a.csv"));
        QVERIFY(made.open(QIODevice::WriteOnly) && made.write(QByteArray(1500, 'a')) == 1500 && made.flush());
        QVERIFY(made.setFileTime(QDateTime({2026, 3, 9}, {14, 5}), QFileDevice::FileModificationTime));
        made.close();
        QVERIFY(QDir(folder.path()).mkdir("other"));
        const QLocale before;
        for (const auto& [locale, size, date] :
             {std::tuple("de", "1,46 KiB", "09.03.26 14:05"), std::tuple("ja", "1.46 KiB", "2026/03/09 14:05")}) {
            QLocale::setDefault(QLocale(QString(locale)));
            ui::kit::FileDialog dialog(nullptr, "Choose", folder.path());
            dialog.setAttribute(Qt::WA_DeleteOnClose, false);
            dialog.setViewMode(QFileDialog::Detail);
            dialog.show();
            const auto* view = dialog.findChild<QTreeView*>("treeView");
            const auto cell = [view](int row, int column) {
                return view->model()->index(row, column, view->rootIndex()).data().toString();
            };
            QTRY_COMPARE(cell(1, 0), QString("a.csv"));
            QTRY_COMPARE(cell(1, 1), QString(size));
            QCOMPARE(cell(1, 3), QString(date));
            QCOMPARE(cell(0, 1), QString());  // of a folder
        }
        QLocale::setDefault(before);
    }
};

CUSP_TEST(TestFileDialog)
#include "tst_file_dialog.moc"
