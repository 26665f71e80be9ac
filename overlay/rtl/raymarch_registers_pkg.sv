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

  // fractal: four fractal scenes in sixteen greys, bricks, dither, checkerboard (source 001)
  localparam int FRACTAL_KIND = 1;
  localparam int FRACTAL_WORDS = 7;
  function automatic logic signed [21:0] fractal_X(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[0][21:0]};
  endfunction
  function automatic logic signed [21:0] fractal_Y(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[1][21:0]};
  endfunction
  function automatic logic signed [21:0] fractal_Z(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[2][21:0]};
  endfunction
  function automatic logic signed [21:0] fractal_FX(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[3][21:0]};
  endfunction
  function automatic logic signed [21:0] fractal_FY(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[4][21:0]};
  endfunction
  function automatic logic signed [21:0] fractal_FZ(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[5][21:0]};
  endfunction
  function automatic logic [1:0] fractal_SCENE(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[6][1:0]};
  endfunction
  function automatic logic [0:0] fractal_DITHER(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[6][4:4]};
  endfunction
  function automatic logic [0:0] fractal_TEXTURE(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[6][5:5]};
  endfunction
  function automatic logic [0:0] fractal_CHECKER(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[6][6:6]};
  endfunction
  function automatic logic [0:0] fractal_COLOUR(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[6][7:7]};
  endfunction
  function automatic logic [7:0] fractal_HUE(input logic [31:0] words[FRACTAL_WORDS]);
    return {words[6][15:8]};
  endfunction

endpackage
