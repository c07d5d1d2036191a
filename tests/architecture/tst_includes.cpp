// SPDX-License-Identifier: GPL-3.0-or-later
// Compares every #include in the program's folders with the arrows between them. The table below is the truth: who
// needs a new arrow changes it there, in a commit that says why.
#include <QDirIterator>
#include <QFile>
#include <QLibraryInfo>
#include <QRegularExpression>
#include <QTest>

namespace {

struct Room
{
    const char* folder;      ///< the longest match in the table decides about a file
    QStringList ours;        ///< folders of ours it may include from
    QStringList notOurs;     ///< parts of those that it may not
    QStringList thirdParty;  ///< Qt modules by name ("QtCore"), other libraries by how their includes begin
    const char* ruleInWords;
};

/// What the operating system and the compiler offer beside the C++ standard library, which everyone may use.
const QStringList kSystem{"fcntl.h", "pthread.h", "sched.h", "sys/", "termios.h", "time.h", "unistd.h"};

const QStringList kWindow{"QtCore",          "QtGui", "QtWidgets",      "QtOpenGL",
                          "QtOpenGLWidgets", "QtSvg", "QtPrintSupport", "glm/"};

const QList<Room> kRooms{
    {"core/",
     {"core/"},
     {"core/tracking/"},
     QStringList{"glm/", "tl/", "zstd"} + kSystem,
     "core is standard C++, GLM, tl::expected and Zstandard: no Qt, no OpenGL, no other folder"},
    {"core/tracking/",
     {"core/"},
     {},
     QStringList{"glm/", "tl/", "apriltag/", "opencv2/", "dlfcn.h"} + kSystem,
     "core/tracking is the only code that sees AprilTag and OpenCV"},
    {"haptics/",
     {"haptics/", "core/"},
     {},
     QStringList{"glm/", "sodium", "libusb-1.0/", "SDL.h"} + kSystem,
     "haptics sees core, libsodium, libusb and SDL 2: no Qt, no window"},
    {"lab/", {"lab/", "haptics/", "core/"}, {}, {"glm/"}, "lab sees core and haptics: no Qt, no window"},
    {"lessons/",
     {"lessons/", "core/"},
     {},
     {"QtCore", "glm/"},
     "lessons sees core and QtCore: it opens no window and no database"},
    {"database/",
     {"database/", "lessons/", "core/"},
     {},
     QStringList{"QtCore", "QtSql", "sodium", "sqlite3"} + kSystem,
     "database sees lessons, core, QtCore, QtSql, SQLite and libsodium: it shows nothing"},
    {"ui/",
     {"ui/", "database/", "lessons/", "core/"},
     {"database/sql/"},
     kWindow,
     "ui sees core, lessons, the interfaces of database and Qt: it names no device and writes no SQL"},
    {"ui/render/",
     {"ui/render/", "core/"},
     {},
     {"QtCore", "QtGui", "QtOpenGL", "glm/"},
     "ui/render is OpenGL only: it sees core and Qt's OpenGL, no widgets and no other part of ui"},
    {"ui/sound/",
     {"ui/sound/", "core/"},
     {},
     {"QtCore", "QtMultimedia"},
     "ui/sound plays what core/audio makes: it alone sees Qt Multimedia, and it shows nothing"},
    {"app/",
     {"app/", "ui/", "lab/", "haptics/", "database/", "lessons/", "core/"},
     {},
     QStringList{"Qt", "glm/"} + kSystem,
     "app may include everything of ours; the libraries behind haptics and core stay behind them"},
};

const QStringList kFolders{"core", "haptics", "lab", "lessons", "database", "ui", "app"};

const Room* roomOf(const QString& file)
{
    const Room* best = nullptr;
    for (const Room& room : kRooms)
        if (file.startsWith(room.folder) && (best == nullptr || qstrlen(room.folder) > qstrlen(best->folder)))
            best = &room;
    return best;
}

bool startsWithAny(const QString& text, const QStringList& beginnings)
{
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const QString& b) { return text.startsWith(b); });
}

/// "QtWidgets" for QLabel, QtWidgets/QLabel and qlabel.h; empty for what is not Qt's.
QString qtModuleOf(const QString& include)
{
    static const QDir headers(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    static const QStringList modules = headers.entryList({"Qt*"}, QDir::Dirs);
    if (QString folder = include.section('/', 0, 0); include.contains('/') && folder.startsWith("Qt"))
        return folder;
    for (const QString& module : modules)
        if (headers.exists(module + '/' + include))
            return module;
    // A Qt class that is not installed here is still Qt's, of a module nobody was allowed.
    static const QRegularExpression qtClass("^Q[A-Z]\\w*$");
    return qtClass.match(include).hasMatch() ? QStringLiteral("Qt of an unknown module") : QString();
}

/// The rule that this line breaks, in words; empty when the line is no #include or an allowed one.
QString complaint(const QString& file, const QString& line)
{
    static const QRegularExpression directive("^\\s*#\\s*include\\b\\s*(.*)$");
    static const QRegularExpression name("^([<\"])([^>\"]+)[>\"]");
    const auto isInclude = directive.match(line);
    if (!isInclude.hasMatch())
        return {};
    const auto parts = name.match(isInclude.captured(1));
    if (!parts.hasMatch())
        return "an include names its file: no macros";
    const bool quoted = parts.captured(1) == "\"";
    const QString include = parts.captured(2);
    const Room& room = *roomOf(file);

    if (quoted) {
        if (include == QFileInfo(file).completeBaseName() + ".moc")
            return {};
        if (roomOf(include) == nullptr)
            return "\"\" is for our own files, written from the root of the repository (\"core/base/Result.h\")";
        const bool allowed = startsWithAny(include, room.ours) && !startsWithAny(include, room.notOurs);
        return allowed ? QString() : QString(room.ruleInWords);
    }
    if (roomOf(include) != nullptr)
        return "our own files are included with \"\", not with <>";
    static const QRegularExpression standard("^[a-z_]+$");
    if (const QString module = qtModuleOf(include); !module.isEmpty())
        return room.thirdParty.contains(module) || room.thirdParty.contains("Qt") ? QString()
                                                                                  : QString(room.ruleInWords);
    const bool allowed = standard.match(include).hasMatch() || startsWithAny(include, room.thirdParty);
    return allowed ? QString() : QString(room.ruleInWords);
}

/// Whether a line of the window's puts a box before it, which stops all else until it is answered. What is to be said
/// or asked stands within the page: MessageBar, QuestionCard. Where to save and what to print on is asked by FileDialog
/// and QPrintDialog, by open(), beside which the window goes on.
bool putsABox(QString line)
{
    static const QRegularExpression box(
        "\\bQ(MessageBox|ErrorMessage|InputDialog|ProgressDialog|Wizard|ColorDialog|FontDialog)\\b|"
        "\\bQFileDialog::get|\\b(public|new) QDialog\\b|\\bQDialog \\w+[;({]|"
        "\\bsetModal\\b|\\b(Application|Window)Modal\\b|\\bQEventLoop \\w");
    static const QRegularExpression waits("(\\w+::)?\\bexec\\(");
    line = line.section("//", 0, 0);
    if (line.contains(box))
        return true;
    const auto wait = waits.match(line);
    return wait.hasMatch() && wait.captured(1) != "QApplication::";
}

/// Reads each source file of these folders: its name from the root of the repository, and its text.
template <class Use>
void forEachSource(const QStringList& folders, Use&& use)
{
    const QDir root(CUSP_SOURCE_DIR);
    for (const QString& folder : folders) {
        QDirIterator it(root.filePath(folder),
                        {"*.h", "*.hpp", "*.inc", "*.inl", "*.ipp", "*.c", "*.cc", "*.cpp", "*.cxx"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile source(it.next());
            QVERIFY2(source.open(QIODevice::ReadOnly), qPrintable(source.fileName()));
            use(root.relativeFilePath(source.fileName()), QString::fromUtf8(source.readAll()));
        }
    }
}

}  // namespace

class TestIncludes : public QObject
{
    Q_OBJECT

private slots:
    void plantedLines_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("line");
        QTest::addColumn<bool>("allowed");
        const auto plant = [](const char* file, const QStringList& allowed, const QStringList& refused) {
            for (const QString& include : allowed + refused)
                QTest::newRow(qPrintable(file + (": " + include)))
                    << file << "#include " + include << allowed.contains(include);
        };
        plant("core/mesh/A.cpp", {"<vector>", "\"core/mesh/A.h\""},
              {"<assimp/Importer.hpp>", "<QString>", "<qglobal.h>", "<GL/gl.h>", "<opencv2/core.hpp>",
               "\"lessons/ScoreSheet.h\"", "\"A.h\"", "<core/mesh/A.h>", "SOME_HEADER"});
        plant("haptics/A.cpp", {"\"core/rt/SpscQueue.h\""},
              {"<QObject>", "\"ui/text/Texts.h\"", "\"lab/StiffnessLimit.h\""});
        plant("lab/A.cpp", {"\"haptics/HapticDevice.h\""}, {"<QObject>"});
        plant("lessons/A.cpp", {"<QJsonDocument>"}, {"<QImage>", "\"database/records.h\""});
        plant("database/sql/A.cpp", {"<QSqlQuery>"}, {"<QMessageBox>"});
        plant("database/A.h", {"\"lessons/ScoreSheet.h\""}, {"\"ui/text/Texts.h\""});
        plant("ui/tooth/A.cpp", {"<QOpenGLWidget>", "\"database/records.h\"", "\"A.moc\""},
              {"\"database/sql/Attempts.h\"", "<QSqlQuery>", "\"haptics/HapticDevice.h\"", "\"app/cli/Commands.h\"",
               "\"B.moc\""});
        plant("ui/render/A.cpp", {"<QOpenGLBuffer>"}, {"<QWidget>", "<QOpenGLWidget>", "\"ui/tooth/Camera.h\""});
        plant("app/A.cpp", {"\"haptics/HapticDevice.h\"", "<QApplication>"},
              {"<libusb-1.0/libusb.h>", "\"tests/support/Allocations.h\""});
        QTest::newRow("spaces") << "core/mesh/A.cpp"
                                << "  #  include <QtCore/qglobal.h>" << false;
        QTest::newRow("a comment") << "core/mesh/A.cpp"
                                   << "// talks about #include <QString>" << true;
    }

    void plantedLines()
    {
        QFETCH(QString, file);
        QFETCH(QString, line);
        QFETCH(bool, allowed);
        QCOMPARE(complaint(file, line).isEmpty(), allowed);
    }

    void theQtHeadersAreFound()
    {
        QCOMPARE(qtModuleOf("QString"), QString("QtCore"));
        QCOMPARE(qtModuleOf("QTest"), QString("QtTest"));
        QCOMPARE(qtModuleOf("vector"), QString());
    }

    void everyIncludeFollowsAnArrow_data()
    {
        QTest::addColumn<QString>("folder");
        for (const QString& folder : kFolders)
            QTest::newRow(qPrintable(folder)) << folder;
    }

    void everyIncludeFollowsAnArrow()
    {
        QFETCH(QString, folder);
        int files = 0;
        QStringList complaints;
        forEachSource({folder}, [&](const QString& name, const QString& text) {
            ++files;
            for (int number = 1; const QString& line : text.split('\n')) {
                if (const QString rule = complaint(name, line.trimmed()); !rule.isEmpty())
                    complaints << QString("%1:%2: %3\n    %4").arg(name).arg(number).arg(line, rule);
                ++number;
            }
        });
        QVERIFY2(files > 0, "no source files were found: is CUSP_SOURCE_DIR right?");
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
    }

    /// QSaveFile::commit() does not notice when the last 16 kB find no room on the disk: it gives an empty file its
    /// name (Qt 6.4). So each caller of commit() calls flush() before.
    void whatIsSavedWasWritten()
    {
        int files = 0;
        forEachSource(kFolders, [&](const QString& name, const QString& text) {
            if (!text.contains("QSaveFile "))  // has one of its own
                return;
            ++files;
            const auto commits = text.count(".commit()");
            QVERIFY2(commits > 0 && text.count(".flush()") >= commits, qPrintable(name));
        });
        QVERIFY(files > 0);
    }

    void plantedBoxes_data()
    {
        QTest::addColumn<bool>("isBox");
        for (const char* box :
             {"QMessageBox::warning(this, title, words);", "#include <QMessageBox>",
              "QInputDialog::getText(this, title, label);", "const QString file = QFileDialog::getOpenFileName(this);",
              "class Question : public QDialog", "auto* box = new QDialog(this);", "QDialog box(this);",
              "dialog->exec();", "menu.exec(QCursor::pos());", "setWindowModality(Qt::ApplicationModal);",
              "QEventLoop loop;"})
            QTest::newRow(box) << true;
        for (const char* none : {"return QApplication::exec();", "dialog->open();", "// instead of a QMessageBox",
                                 "connect(dialog, &QDialog::accepted, this, done);",
                                 "class FileDialog : public QFileDialog", "m_console->execute(command);"})
            QTest::newRow(none) << false;
    }

    void plantedBoxes()
    {
        QFETCH(bool, isBox);
        QCOMPARE(putsABox(QTest::currentDataTag()), isBox);
    }

    void thePageSpeaksAndNoBox()
    {
        int files = 0;
        QStringList boxes;
        forEachSource({"ui", "app"}, [&](const QString& name, const QString& text) {
            ++files;
            for (int number = 1; const QString& line : text.split('\n')) {
                if (putsABox(line.trimmed()))
                    boxes << QString("%1:%2: %3").arg(name).arg(number).arg(line);
                ++number;
            }
        });
        QVERIFY(files > 100);
        QVERIFY2(boxes.isEmpty(), qPrintable('\n' + boxes.join('\n')));
    }
};

QTEST_GUILESS_MAIN(TestIncludes)
#include "tst_includes.moc"
