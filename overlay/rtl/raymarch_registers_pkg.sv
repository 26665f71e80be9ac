// SPDX-License-Identifier: MIT
// Made by dump_tables from protocol/; ./dev docs writes it again.
package raymarch_registers_pkg;

  // Byte offsets of the extended registers
  localparam logic [11:0] ID_OFFSET = 12'h020;
  localparam logic [11:0] VERSION_OFFSET = 12'h024;
  localparam logic [11:0] CAPABILITY_OFFSET = 12'h028;
  localparam logic [11:0] GEOMETRY_OFFSET = 12'h02C;
  localparam logic [11:0] CONTROL_OFFSET = 12'h030;
  localparam logic [11:0] COMMIT_OFFSET = 12'h034;
  localparam logic [11:0] STATUS_OFFSET = 12'h038;
  localparam logic [11:0] FRAMES_OFFSET = 12'h03C;
  localparam logic [11:0] CYCLES_OFFSET = 12'h040;
  localparam logic [11:0] CLOCK_HZ_OFFSET = 12'h044;
  localparam logic [11:0] SCRATCH_OFFSET = 12'h048;
  localparam logic [31:0] ID_VALUE = 32'h524D4152;

  // marcher: signed distance scenes by sphere tracing, Lambert and ambient light (source 000)
  localparam int MARCHER_KIND = 0;
  localparam int MARCHER_WORDS = 8;
  function automatic logic signed [17:0] marcher_FX(input logic [31:0] words[MARCHER_WORDS]);
    return {words[2][31:14]};
  endfunction
  function automatic logic signed [17:0] marcher_FY(input logic [31:0] words[MARCHER_WORDS]);
    return {words[2][13:0], words[3][31:28]};
  endfunction
  function automatic logic signed [17:0] marcher_FZ(input logic [31:0] words[MARCHER_WORDS]);
    return {words[3][27:10]};
  endfunction
  function automatic logic signed [17:0] marcher_RX(input logic [31:0] words[MARCHER_WORDS]);
    return {words[4][31:14]};
  endfunction
  function automatic logic signed [17:0] marcher_RY(input logic [31:0] words[MARCHER_WORDS]);
    return {words[4][13:0], words[5][31:28]};
  endfunction
  function automatic logic signed [17:0] marcher_RZ(input logic [31:0] words[MARCHER_WORDS]);
    return {words[5][27:10]};
  endfunction
  function automatic logic signed [17:0] marcher_UX(input logic [31:0] words[MARCHER_WORDS]);
    return {words[6][31:14]};
  endfunction
  function automatic logic signed [17:0] marcher_UY(input logic [31:0] words[MARCHER_WORDS]);
    return {words[6][13:0], words[7][31:28]};
  endfunction
  function automatic logic signed [17:0] marcher_UZ(input logic [31:0] words[MARCHER_WORDS]);
    return {words[7][27:10]};
  endfunction
  function automatic logic [31:0] marcher_ZM(input logic [31:0] words[MARCHER_WORDS]);
    return {words[1][31:0]};
  endfunction
  function automatic logic signed [9:0] marcher_LX(input logic [31:0] words[MARCHER_WORDS]);
    return {words[0][29:20]};
  endfunction
  function automatic logic signed [9:0] marcher_LY(input logic [31:0] words[MARCHER_WORDS]);
    return {words[0][19:10]};
  endfunction
  function automatic logic signed [9:0] marcher_LZ(input logic [31:0] words[MARCHER_WORDS]);
    return {words[0][9:0]};
  endfunction
  function automatic logic [9:0] marcher_R(input logic [31:0] words[MARCHER_WORDS]);
    return {words[3][9:0]};
  endfunction
  function automatic logic [9:0] marcher_G(input logic [31:0] words[MARCHER_WORDS]);
    return {words[5][9:0]};
  endfunction
  function automatic logic [9:0] marcher_B(input logic [31:0] words[MARCHER_WORDS]);
    return {words[7][9:0]};
  endfunction
  function automatic logic [1:0] marcher_OBJ(input logic [31:0] words[MARCHER_WORDS]);
    return {words[0][31:30]};
  endfunction

  // mandelbulb: deep-zoom Mandelbulb by 3D CORDIC and BKM (source 003)
  localparam int MANDELBULB_KIND = 3;
  localparam int MANDELBULB_WORDS = 27;
  function automatic logic signed [71:0] mandelbulb_X(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[2][7:0], words[3][31:0], words[4][31:0]};
  endfunction
  function automatic logic signed [71:0] mandelbulb_Y(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[2][15:8], words[5][31:0], words[6][31:0]};
  endfunction
  function automatic logic signed [71:0] mandelbulb_Z(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[2][23:16], words[7][31:0], words[8][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_FX(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[9][26:0], words[10][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_FY(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[11][26:0], words[12][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_FZ(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[13][26:0], words[14][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_RX(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[15][26:0], words[16][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_RY(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[17][26:0], words[18][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_RZ(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[19][26:0], words[20][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_UX(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[21][26:0], words[22][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_UY(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[23][26:0], words[24][31:0]};
  endfunction
  function automatic logic signed [58:0] mandelbulb_UZ(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[25][26:0], words[26][31:0]};
  endfunction
  function automatic logic [6:0] mandelbulb_N(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][14:8]};
  endfunction
  function automatic logic [6:0] mandelbulb_K(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][22:16]};
  endfunction
  function automatic logic [4:0] mandelbulb_POWER(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][28:24]};
  endfunction
  function automatic logic [6:0] mandelbulb_I(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[1][6:0]};
  endfunction
  function automatic logic [4:0] mandelbulb_B(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[1][12:8]};
  endfunction
  function automatic logic [7:0] mandelbulb_STEPS(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[1][23:16]};
  endfunction
  function automatic logic [0:0] mandelbulb_FORM(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][0:0]};
  endfunction
  function automatic logic [0:0] mandelbulb_DERIVATIVE(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][1:1]};
  endfunction
  function automatic logic [5:0] mandelbulb_SCALE(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[1][29:24]};
  endfunction
  function automatic logic [0:0] mandelbulb_COLOUR(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][2:2]};
  endfunction
  function automatic logic [0:0] mandelbulb_ASPECT(input logic [31:0] words[MANDELBULB_WORDS]);
    return {words[0][3:3]};
  endfunction

endpackage
