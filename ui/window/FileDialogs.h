// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <QImage>
#include <QObject>
#include <QStringList>

class QMimeData;

namespace ui::kit {
class MessageBar;
}

namespace ui::window {

/// Opens the file dialogs of the window. Each kind of file has its own last folder, which is saved between runs.
///
/// A dialog does not block: the program continues to run, and the caller's function is called with the chosen path.
class FileDialogs final : public QObject
{
    Q_OBJECT
public:
    enum class Kind { Scan, Recording, Picture, Reference, Preset, Table };
    using Chosen = std::function<void(const QString& path)>;

    /// File name endings of scans, without the dot.
    [[nodiscard]] static QStringList scanSuffixes() { return {"obj", "stl", "ply"}; }
    [[nodiscard]] static QString suffixOf(Kind kind);
    /// Returns the path of the file that is dragged; empty if several files or something else is dragged.
    [[nodiscard]] static QString droppedFile(const QMimeData& data);
    /// Returns a name for a new file: tooth, day and time.
    /// @param tooth  name of the anatomy: a file, or a block such as "block:line"
    [[nodiscard]] static QString newFileName(const std::string& tooth, Kind kind);

    /// @param window  parent of the dialogs
    FileDialogs(QWidget& window, kit::MessageBar& messages);

    /// Asks for an existing file.
    void open(const QString& title, Kind kind, const Chosen& chosen);
    /// Asks where to write a new file.
    void save(const QString& title, Kind kind, const QString& newName, const Chosen& chosen);
    /// Asks for a path, writes the picture as PNG, and shows whether that worked.
    /// @param picture  called when the path is known
    void savePicture(const QString& title, const QString& newName, const std::function<QImage()>& picture);
    /// Does the same for a comparison of presets, as CSV.
    void saveComparison(const QString& title, const QString& newName, const QByteArray& csv);

private:
    void ask(const QString& title, Kind kind, const QString& newName, const Chosen& chosen);
    void showSaved(const QString& sentence);
    void showFailure(const QString& sentence, const QString& path, const QString& technical);

    QWidget& m_window;
    kit::MessageBar& m_messages;
};

}  // namespace ui::window
