// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Program.h"

#include <cstdlib>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

namespace support {
namespace {

QByteArray contents(const QByteArray& name)
{
    QFile file(QString::fromLocal8Bit(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

QJsonObject Ending::json() const
{
    return QJsonDocument::fromJson(out).object();
}

bool Ending::isOneSentence() const
{
    return out.isEmpty() && error.startsWith("cusp: ") && error.endsWith(".\n") && error.count('\n') == 1;
}

Ending runCusp(const QStringList& arguments, const QStringList& environment, const QByteArray& input)
{
    // Not QProcess, because wait4() reports the peak memory of exactly this process.
    const QTemporaryDir folder;
    const QByteArray outFile = folder.filePath(QStringLiteral("out")).toLocal8Bit();
    const QByteArray errorFile = folder.filePath(QStringLiteral("error")).toLocal8Bit();
    const QByteArray inFile = folder.filePath(QStringLiteral("in")).toLocal8Bit();
    QFile in(QString::fromLocal8Bit(inFile));
    if (in.open(QIODevice::WriteOnly))
        in.write(input);
    in.close();
    std::vector<QByteArray> words{QByteArray(CUSP_BINARY_DIR "/bin/cusp")};
    for (const QString& argument : arguments)
        words.push_back(argument.toLocal8Bit());
    std::vector<QByteArray> settings;
    for (const QString& setting : environment)
        settings.push_back(setting.toLocal8Bit());
    std::vector<char*> argv;
    for (QByteArray& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(open(inFile.constData(), O_RDONLY), 0);
        dup2(open(outFile.constData(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
        dup2(open(errorFile.constData(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            unsetenv(name);
        for (QByteArray& setting : settings)
            putenv(setting.data());
        execv(argv[0], argv.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(outFile), contents(errorFile),
            usage.ru_maxrss / 1024};
}

void expectDone(const Ending& ending, const char* file, int line)
{
    QTest::qVerify(ending.exitCode == 0, "exit code 0", (ending.error + ending.out).constData(), file, line);
}

void expectRefusal(const Ending& ending, const QByteArray& words, int exitCode, const char* file, int line)
{
    QTest::qVerify(ending.exitCode == exitCode && ending.isOneSentence() && ending.error.contains(words),
                   ("refused: " + words).constData(), (ending.error + ending.out).constData(), file, line);
}

}  // namespace support
