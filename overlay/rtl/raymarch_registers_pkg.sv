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

  // sphere: spheres and lights by integer intersection, shadows, inverse square (source 002)
  localparam int SPHERE_KIND = 2;
  localparam int SPHERE_WORDS = 50;
  function automatic logic [1:0] sphere_MODEL(input logic [31:0] words[SPHERE_WORDS]);
    return {words[0][1:0]};
  endfunction
  function automatic logic [1:0] sphere_FAULTS(input logic [31:0] words[SPHERE_WORDS]);
    return {words[0][3:2]};
  endfunction
  function automatic logic [0:0] sphere_TINT(input logic [31:0] words[SPHERE_WORDS]);
    return {words[0][4:4]};
  endfunction
  function automatic logic [1:0] sphere_N(input logic [31:0] words[SPHERE_WORDS]);
    return {words[0][9:8]};
  endfunction
  function automatic logic [3:0] sphere_M(input logic [31:0] words[SPHERE_WORDS]);
    return {words[0][15:12]};
  endfunction
  function automatic logic [7:0] sphere_CUTOFF(input logic [31:0] words[SPHERE_WORDS]);
    return {words[0][23:16]};
  endfunction
  function automatic logic [15:0] sphere_D(input logic [31:0] words[SPHERE_WORDS]);
    return {words[1][31:16]};
  endfunction
  function automatic logic [15:0] sphere_K(input logic [31:0] words[SPHERE_WORDS]);
    return {words[1][15:0]};
  endfunction
  function automatic logic signed [16:0] sphere_EX(input logic [31:0] words[SPHERE_WORDS]);
    return {words[2][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_EY(input logic [31:0] words[SPHERE_WORDS]);
    return {words[3][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_EZ(input logic [31:0] words[SPHERE_WORDS]);
    return {words[4][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_F(input logic [31:0] words[SPHERE_WORDS]);
    return {words[5][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S1_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[6][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S1_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[7][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S1_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[8][16:0]};
  endfunction
  function automatic logic [15:0] sphere_S1_R(input logic [31:0] words[SPHERE_WORDS]);
    return {words[9][15:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S2_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[10][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S2_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[11][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S2_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[12][16:0]};
  endfunction
  function automatic logic [15:0] sphere_S2_R(input logic [31:0] words[SPHERE_WORDS]);
    return {words[13][15:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S3_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[14][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S3_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[15][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_S3_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[16][16:0]};
  endfunction
  function automatic logic [15:0] sphere_S3_R(input logic [31:0] words[SPHERE_WORDS]);
    return {words[17][15:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L1_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[18][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L1_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[19][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L1_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[20][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L1_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[21][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L2_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[22][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L2_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[23][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L2_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[24][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L2_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[25][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L3_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[26][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L3_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[27][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L3_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[28][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L3_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[29][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L4_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[30][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L4_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[31][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L4_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[32][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L4_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[33][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L5_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[34][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L5_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[35][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L5_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[36][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L5_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[37][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L6_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[38][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L6_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[39][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L6_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[40][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L6_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[41][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L7_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[42][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L7_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[43][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L7_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[44][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L7_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[45][30:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L8_X(input logic [31:0] words[SPHERE_WORDS]);
    return {words[46][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L8_Y(input logic [31:0] words[SPHERE_WORDS]);
    return {words[47][16:0]};
  endfunction
  function automatic logic signed [16:0] sphere_L8_Z(input logic [31:0] words[SPHERE_WORDS]);
    return {words[48][16:0]};
  endfunction
  function automatic logic [30:0] sphere_L8_S(input logic [31:0] words[SPHERE_WORDS]);
    return {words[49][30:0]};
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

  // whitted: spheres and planes with shadows, reflections and anti-aliasing in 12.12 (source 004)
  localparam int WHITTED_KIND = 4;
  localparam int WHITTED_WORDS = 88;
  function automatic logic [0:0] whitted_PROFILE(input logic [31:0] words[WHITTED_WORDS]);
    return {words[0][31:31]};
  endfunction
  function automatic logic signed [23:0] whitted_EX(input logic [31:0] words[WHITTED_WORDS]);
    return {words[1][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_EY(input logic [31:0] words[WHITTED_WORDS]);
    return {words[2][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_EZ(input logic [31:0] words[WHITTED_WORDS]);
    return {words[3][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_LX(input logic [31:0] words[WHITTED_WORDS]);
    return {words[4][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_LY(input logic [31:0] words[WHITTED_WORDS]);
    return {words[5][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_LZ(input logic [31:0] words[WHITTED_WORDS]);
    return {words[6][31:8]};
  endfunction
  function automatic logic [10:0] whitted_LR(input logic [31:0] words[WHITTED_WORDS]);
    return {words[0][10:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S(input logic [31:0] words[WHITTED_WORDS]);
    return {words[7][31:8]};
  endfunction
  function automatic logic [1:0] whitted_REFLECTIONS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[0][28:27]};
  endfunction
  function automatic logic [1:0] whitted_AA(input logic [31:0] words[WHITTED_WORDS]);
    return {words[0][26:25]};
  endfunction
  function automatic logic [0:0] whitted_PLANES(input logic [31:0] words[WHITTED_WORDS]);
    return {words[0][30:30]};
  endfunction
  function automatic logic [3:0] whitted_N(input logic [31:0] words[WHITTED_WORDS]);
    return {words[0][24:21]};
  endfunction
  function automatic logic signed [23:0] whitted_S1_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[8][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S1_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[9][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S1_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[10][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S1_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[11][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S1_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[8][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S1_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[9][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S1_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[10][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S1_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[11][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S2_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[12][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S2_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[13][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S2_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[14][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S2_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[15][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S2_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[12][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S2_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[13][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S2_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[14][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S2_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[15][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S3_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[16][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S3_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[17][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S3_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[18][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S3_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[19][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S3_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[16][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S3_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[17][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S3_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[18][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S3_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[19][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S4_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[20][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S4_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[21][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S4_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[22][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S4_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[23][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S4_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[20][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S4_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[21][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S4_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[22][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S4_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[23][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S5_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[24][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S5_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[25][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S5_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[26][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S5_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[27][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S5_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[24][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S5_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[25][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S5_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[26][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S5_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[27][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S6_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[28][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S6_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[29][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S6_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[30][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S6_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[31][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S6_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[28][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S6_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[29][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S6_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[30][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S6_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[31][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S7_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[32][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S7_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[33][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S7_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[34][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S7_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[35][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S7_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[32][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S7_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[33][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S7_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[34][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S7_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[35][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S8_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[36][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S8_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[37][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S8_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[38][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S8_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[39][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S8_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[36][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S8_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[37][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S8_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[38][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S8_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[39][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S9_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[40][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S9_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[41][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S9_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[42][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S9_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[43][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S9_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[40][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S9_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[41][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S9_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[42][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S9_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[43][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S10_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[44][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S10_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[45][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S10_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[46][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S10_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[47][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S10_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[44][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S10_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[45][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S10_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[46][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S10_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[47][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S11_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[48][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S11_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[49][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S11_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[50][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S11_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[51][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S11_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[48][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S11_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[49][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S11_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[50][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S11_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[51][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S12_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[52][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S12_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[53][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S12_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[54][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S12_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[55][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S12_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[52][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S12_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[53][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S12_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[54][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S12_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[55][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S13_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[56][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S13_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[57][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S13_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[58][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S13_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[59][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S13_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[56][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S13_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[57][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S13_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[58][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S13_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[59][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_S14_X(input logic [31:0] words[WHITTED_WORDS]);
    return {words[60][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S14_Y(input logic [31:0] words[WHITTED_WORDS]);
    return {words[61][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_S14_Z(input logic [31:0] words[WHITTED_WORDS]);
    return {words[62][31:8]};
  endfunction
  function automatic logic [10:0] whitted_S14_RADIUS(input logic [31:0] words[WHITTED_WORDS]);
    return {words[63][22:12]};
  endfunction
  function automatic logic [4:0] whitted_S14_R(input logic [31:0] words[WHITTED_WORDS]);
    return {words[60][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S14_G(input logic [31:0] words[WHITTED_WORDS]);
    return {words[61][4:0]};
  endfunction
  function automatic logic [4:0] whitted_S14_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[62][4:0]};
  endfunction
  function automatic logic [11:0] whitted_S14_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[63][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_A(input logic [31:0] words[WHITTED_WORDS]);
    return {words[64][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[65][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_C(input logic [31:0] words[WHITTED_WORDS]);
    return {words[66][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P1_D(input logic [31:0] words[WHITTED_WORDS]);
    return {words[67][31:8]};
  endfunction
  function automatic logic [4:0] whitted_P1_RED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[64][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P1_GREEN(input logic [31:0] words[WHITTED_WORDS]);
    return {words[65][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P1_BLUE(input logic [31:0] words[WHITTED_WORDS]);
    return {words[66][4:0]};
  endfunction
  function automatic logic [3:0] whitted_P1_CHECKER(input logic [31:0] words[WHITTED_WORDS]);
    return {words[67][3:0]};
  endfunction
  function automatic logic [0:0] whitted_P1_BOUNDED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[67][4:4]};
  endfunction
  function automatic logic [11:0] whitted_P1_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[68][11:0]};
  endfunction
  function automatic logic [11:0] whitted_P1_XL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[68][23:12]};
  endfunction
  function automatic logic [11:0] whitted_P1_YL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[69][27:16]};
  endfunction
  function automatic logic [11:0] whitted_P1_ZL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[69][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_A(input logic [31:0] words[WHITTED_WORDS]);
    return {words[70][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[71][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_C(input logic [31:0] words[WHITTED_WORDS]);
    return {words[72][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P2_D(input logic [31:0] words[WHITTED_WORDS]);
    return {words[73][31:8]};
  endfunction
  function automatic logic [4:0] whitted_P2_RED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[70][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P2_GREEN(input logic [31:0] words[WHITTED_WORDS]);
    return {words[71][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P2_BLUE(input logic [31:0] words[WHITTED_WORDS]);
    return {words[72][4:0]};
  endfunction
  function automatic logic [3:0] whitted_P2_CHECKER(input logic [31:0] words[WHITTED_WORDS]);
    return {words[73][3:0]};
  endfunction
  function automatic logic [0:0] whitted_P2_BOUNDED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[73][4:4]};
  endfunction
  function automatic logic [11:0] whitted_P2_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[74][11:0]};
  endfunction
  function automatic logic [11:0] whitted_P2_XL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[74][23:12]};
  endfunction
  function automatic logic [11:0] whitted_P2_YL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[75][27:16]};
  endfunction
  function automatic logic [11:0] whitted_P2_ZL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[75][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_A(input logic [31:0] words[WHITTED_WORDS]);
    return {words[76][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[77][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_C(input logic [31:0] words[WHITTED_WORDS]);
    return {words[78][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P3_D(input logic [31:0] words[WHITTED_WORDS]);
    return {words[79][31:8]};
  endfunction
  function automatic logic [4:0] whitted_P3_RED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[76][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P3_GREEN(input logic [31:0] words[WHITTED_WORDS]);
    return {words[77][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P3_BLUE(input logic [31:0] words[WHITTED_WORDS]);
    return {words[78][4:0]};
  endfunction
  function automatic logic [3:0] whitted_P3_CHECKER(input logic [31:0] words[WHITTED_WORDS]);
    return {words[79][3:0]};
  endfunction
  function automatic logic [0:0] whitted_P3_BOUNDED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[79][4:4]};
  endfunction
  function automatic logic [11:0] whitted_P3_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[80][11:0]};
  endfunction
  function automatic logic [11:0] whitted_P3_XL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[80][23:12]};
  endfunction
  function automatic logic [11:0] whitted_P3_YL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[81][27:16]};
  endfunction
  function automatic logic [11:0] whitted_P3_ZL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[81][11:0]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_A(input logic [31:0] words[WHITTED_WORDS]);
    return {words[82][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_B(input logic [31:0] words[WHITTED_WORDS]);
    return {words[83][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_C(input logic [31:0] words[WHITTED_WORDS]);
    return {words[84][31:8]};
  endfunction
  function automatic logic signed [23:0] whitted_P4_D(input logic [31:0] words[WHITTED_WORDS]);
    return {words[85][31:8]};
  endfunction
  function automatic logic [4:0] whitted_P4_RED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[82][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P4_GREEN(input logic [31:0] words[WHITTED_WORDS]);
    return {words[83][4:0]};
  endfunction
  function automatic logic [4:0] whitted_P4_BLUE(input logic [31:0] words[WHITTED_WORDS]);
    return {words[84][4:0]};
  endfunction
  function automatic logic [3:0] whitted_P4_CHECKER(input logic [31:0] words[WHITTED_WORDS]);
    return {words[85][3:0]};
  endfunction
  function automatic logic [0:0] whitted_P4_BOUNDED(input logic [31:0] words[WHITTED_WORDS]);
    return {words[85][4:4]};
  endfunction
  function automatic logic [11:0] whitted_P4_REFLECT(input logic [31:0] words[WHITTED_WORDS]);
    return {words[86][11:0]};
  endfunction
  function automatic logic [11:0] whitted_P4_XL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[86][23:12]};
  endfunction
  function automatic logic [11:0] whitted_P4_YL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[87][27:16]};
  endfunction
  function automatic logic [11:0] whitted_P4_ZL(input logic [31:0] words[WHITTED_WORDS]);
    return {words[87][11:0]};
  endfunction

endpackage
