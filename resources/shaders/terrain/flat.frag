// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec4 uFlat; // sRGB, opacity
out vec4 oColor;

void main()
{
    oColor = uFlat;
}
