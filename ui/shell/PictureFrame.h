// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

namespace ui::shell {

/// The middle of a picture, filling the space there is, with rounded corners.
class PictureFrame : public QWidget
{
    Q_OBJECT
public:
    explicit PictureFrame(QWidget* parent);
    void setPicture(const QImage& picture);
    [[nodiscard]] QSize sizeHint() const override { return {270, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QImage m_picture;
};

}  // namespace ui::shell
