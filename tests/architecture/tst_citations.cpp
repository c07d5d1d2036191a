// SPDX-License-Identifier: GPL-3.0-or-later
// Every document that a source, a build file or another document cites is in the repository, under the path that is
// written, and has the section that is named.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <QTest>

namespace {

const QString kRoot = QStringLiteral(CUSP_SOURCE_DIR "/");
const QString kBuildFolder = QStringLiteral("build");
/// Inputs of the fuzzers are no text of ours.
const QString kCorpus = QStringLiteral("tests/fuzz/corpus/");
const QStringList kTexts{"*.cpp",  "*.h",   "*.inc", "*.txt", "*.cmake", "*.md",
                         "*.json", "*.sql", "*.sh",  "*.xml", "*.vert",  "*.frag"};

/// Returns the content of a file; empty when it cannot be read.
QString textOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Returns the paths of all texts of the repository, from its root.
QStringList textFiles()
{
    const QDir root(kRoot);
    QStringList files{"dev"};
    files += root.entryList(kTexts, QDir::Files);
    for (const QString& folder : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (folder == kBuildFolder)
            continue;
        QDirIterator it(kRoot + folder, kTexts, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext())
            files << root.relativeFilePath(it.next());
    }
    files.removeIf([](const QString& file) { return file.startsWith(kCorpus); });
    return files;
}

/// Returns the text as one line, without the signs that begin the lines of a comment: citations may be wrapped.
QString unwrapped(QString text)
{
    static const QRegularExpression lineBreak("\\s*\\n\\s*(///?<?|#|\\*)?\\s*");
    return text.replace(lineBreak, " ");
}

/// Returns the targets of links in a Markdown text and removes the links from it. Links to the web are left out.
QStringList takeLinks(QString& text)
{
    static const QRegularExpression link("\\[[^\\]]*\\]\\(([^)\\s]+)\\)");
    QStringList targets;
    for (auto it = link.globalMatch(text); it.hasNext();)
        if (const QString target = it.next().captured(1).section('#', 0, 0); !target.isEmpty() && !target.contains(':'))
            targets << target;
    text.remove(link);
    return targets;
}

bool hasSection(const QString& document, const QString& number)
{
    const QRegularExpression heading("^#+ " + QRegularExpression::escape(number) + "\\.? ",
                                     QRegularExpression::MultilineOption);
    return textOf(kRoot + document).contains(heading);
}

/// Returns the citations of `text`, the content of `file`, that lead nowhere.
QStringList brokenCitations(const QString& file, const QString& text)
{
    QStringList broken;
    QString rest = unwrapped(text);
    if (file.endsWith(".md"))
        for (const QString& target : takeLinks(rest))
            if (!QFileInfo::exists(QFileInfo(kRoot + file).dir().filePath(target)))
                broken << target;
    static const QRegularExpression citation("([\\w./-]+\\.md)\\b(?:,? sections? (\\d+(?:\\.\\d+)*))?");
    for (auto it = citation.globalMatch(rest); it.hasNext();) {
        const auto match = it.next();
        const QString document = match.captured(1);
        if (document.startsWith("//"))  // of a web address
            continue;
        if (!QFileInfo(kRoot + document).isFile())
            broken << document;
        else if (const QString section = match.captured(2); !section.isEmpty() && !hasSection(document, section))
            broken << document + ", section " + section;
    }
    return broken;
}

}  // namespace

class TestCitations : public QObject
{
    Q_OBJECT

private slots:
    void plantedCitations_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("broken");
        // Written apart, so that this file itself cites nothing that is absent.
        const QString absent = QStringLiteral("docs/absent") + ".md";
        const QString bare = QStringLiteral("haptics") + ".md";
        const QString haptics = "docs/facts/" + bare;
        QTest::newRow("a document") << "core/A.h"
                                    << "/// See " + haptics + "." << QString();
        QTest::newRow("an absent document") << "core/A.h"
                                            << "/// See " + absent + '.' << absent;
        QTest::newRow("a bare name") << "core/A.h"
                                     << "/// (" + bare + " 3.3)" << bare;
        QTest::newRow("a section") << "core/A.h" << '(' + haptics + ", section 2.2)" << QString();
        QTest::newRow("a wrapped section") << "core/A.h"
                                           << "/// " + haptics + ", section\n    /// 2.2." << QString();
        QTest::newRow("an absent section") << "core/A.h"
                                           << "/// " + haptics + ",\n/// section 2.9" << haptics + ", section 2.9";
        QTest::newRow("a link beside") << "docs/school.md"
                                       << "[" + bare + "](facts/" + bare + "#1)" << QString();
        QTest::newRow("an absent link") << "docs/school.md"
                                        << "[the facts](" + bare + ')' << bare;
        QTest::newRow("a picture that is absent") << "docs/school.md"
                                                  << "![a chart](charts/none.svg)"
                                                  << "charts/none.svg";
        QTest::newRow("a web address") << "docs/school.md"
                                       << "https://example.org/" + bare << QString();
        QTest::newRow("a pattern") << "core/A.h"
                                   << "docs/*" + QStringLiteral(".md") << QString();
    }

    void plantedCitations()
    {
        QFETCH(QString, file);
        QFETCH(QString, text);
        QFETCH(QString, broken);
        QCOMPARE(brokenCitations(file, text).join(' '), broken);
    }

    void everyCitationLeadsSomewhere()
    {
        const QStringList files = textFiles();
        QVERIFY2(files.size() > 1000, "few files were found: is CUSP_SOURCE_DIR right?");
        QStringList complaints;
        for (const QString& file : files)
            for (const QString& citation : brokenCitations(file, textOf(kRoot + file)))
                complaints << file + " cites " + citation;
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
    }
};

QTEST_GUILESS_MAIN(TestCitations)
#include "tst_citations.moc"
